// The workbench: runs and files of the server; an older answer never replaces a newer one.

async function post(what, body) {
  const options = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
  const response = await fetch(what, options);
  return response.json().catch(() => ({ ok: false, message: `The server answers ${response.status} ${response.statusText}.` }));
}

class BenchServer {
  /** `waits`: is called with true when a run takes more than 0.3 s, with false when none is under way. */
  constructor(waits) {
    this.waits = waits;
    this.number = 0;
    this.hasEnded = false;
  }

  /** The answer to a state; null if a newer run began meanwhile. */
  async run(state) {
    const number = (this.number = Math.max(this.number + 1, Date.now())); // newer than those of a page that was open before
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.waits(true), 300);
    const answer = await post("run", { number, state: sentState(state) }).catch(() => this.unreachable());
    if (number !== this.number || answer.overtaken) return null;
    clearTimeout(this.timer);
    this.waits(false);
    return answer;
  }

  save(state, what) {
    return post("save", { state: sentState(state), what }).catch(() => this.unreachable());
  }

  unreachable() {
    return { ok: false, message: "The server has ended: start quadbench again. This page keeps what was done; its command is below." };
  }

  /** Keeps a connection open, by which the server knows that the page is there; `ended` when it breaks. */
  async keepAlive(ended) {
    try {
      const reader = (await fetch("alive")).body.getReader();
      while (!(await reader.read()).done);
    } catch {
      // ended as well
    }
    ended();
  }
}
