// The workbench: the page that quadbench serves (pipelines/quadbench.md).

function startWorkbench() {
  start();
}
