// The workbench: the page that quadbench serves (pipelines/quadbench.md).

function startWorkbench() {
  addBenchKeys();
  new Workbench(JSON.parse(byId("data").textContent)).start();
}
