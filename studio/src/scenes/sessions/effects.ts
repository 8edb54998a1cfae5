/** What a press or a dropped file sets going: a question to the package, whose answer becomes part of the session. */

import type { Context } from "../../context";
import type { System } from "../../quantities/formatter";
import {
  type Asked,
  initialLive,
  type Job,
  type LiveState,
  NOTHING,
  type Offers,
  type ResultDocument,
  type Session,
  type SessionFile,
  withShots,
} from "../../state/session";
import { ask, askJson, askText, inUnits } from "./api";

type Set = Context["actions"]["session"];
const LOADING = { state: "loading" } as const;

/** Marks something as on its way; false where it is so already. */
function claim(set: Set, name: "offers" | "report" | "golfer"): boolean {
  let isFree = false;
  set((session) => {
    isFree = session[name].state === "none";
    return isFree ? { [name]: LOADING } : {};
  });
  return isFree;
}

/** Asks once what there is, and listens to live shots where there are any. */
export function begin({ model, actions }: Context): void {
  const { api, offers } = model.session;
  if (api === null || offers.state !== "none" || !claim(actions.session, "offers")) return;
  void askJson<Offers>(api).then((answer) => {
    actions.session(() => ({ offers: answer }));
    if (answer.state !== "there") return;
    if (answer.value.studies) void loadStudies(api, actions.session);
    if (answer.value.live) listen(api, actions.session);
  });
}

/** Asks again for what was answered in other units than the page shows now. */
export function followUnits(context: Context): void {
  const { model, state, actions } = context;
  const { system, file, study } = model.session;
  if (system === state.system) return;
  actions.session(() => ({ system: state.system }));
  if (study) openStudy(context, study.name);
  if (file.state !== "there") return;
  const { place } = file.value;
  const again = [place, `${place}/shots`].map((path) => askJson<ResultDocument>(inUnits(path, state.system)));
  void Promise.all(again).then(([read, shots]) => {
    if (read.state !== "there" || shots.state !== "there") return;
    const value = { ...file.value, read: read.value, shots: shots.value };
    actions.session(ifSame(file.value, { file: { state: "there", value }, report: NOTHING, golfer: NOTHING }));
  });
}

/** Reads a file that was chosen: shots of a monitor, or a study or fitting of `clubface optimise`. */
export function readFile({ model, actions, state }: Context, source: File): void {
  const { api, reading, offers } = model.session;
  if (api === null) return;
  if (/\.toml$/i.test(source.name)) {
    actions.change({ kind: "settings", settings: { part: "fitting" } });
    startJob({ model, actions, state }, `${api}fittings`, source);
    return;
  }
  const most = offers.state === "there" ? offers.value.largest_file : Number.POSITIVE_INFINITY;
  const fresh = { source, club: "", marked: null, report: NOTHING, golfer: NOTHING };
  if (source.size > most) {
    const what = `${source.name} is larger than ${most / 1e6} MB; give a smaller file, such as that of one session`;
    actions.session(() => ({ ...fresh, file: { state: "refused", mistake: { where: "", what, allowed: null } } }));
    return;
  }
  actions.session(() => ({ ...fresh, file: LOADING }));
  void read(api, source, reading, state.system).then((file) =>
    actions.session((session) => {
      if (session.source !== source) return {};
      return { file, wishes: { ...session.wishes, only: file.state === "there" ? mainClub(file.value) : "" } };
    }),
  );
}

/** The club with most shots, where a file has several; "" where it has one. */
function mainClub({ shots }: SessionFile): string {
  const counts = new Map<string, number>();
  for (const { club } of shots.tables.shots.rows)
    if (club) counts.set(String(club), (counts.get(String(club)) ?? 0) + 1);
  const most = [...counts].sort(([, one], [, other]) => other - one);
  return most.length > 1 ? most[0][0] : "";
}

async function read(
  api: string,
  source: File,
  reading: Record<string, string>,
  system: System,
): Promise<Asked<SessionFile>> {
  const query = new URLSearchParams({ name: source.name });
  for (const [name, value] of Object.entries(reading)) {
    if (!value) continue;
    if (name === "hand" || name === "format") query.set(name, value);
    else query.append("unit", `${name}=${value}`);
  }
  const bytes = await source.arrayBuffer().catch(() => null);
  if (!bytes) {
    const what = `${source.name} cannot be read; choose it again`;
    return { state: "refused", mistake: { where: "", what, allowed: null } };
  }
  const answer = await ask(
    () => fetch(inUnits(`${api}files?${query}`, system), { method: "POST", body: bytes }),
    async (response) => ({
      place: response.headers.get("location") ?? "",
      read: (await response.json()) as ResultDocument,
    }),
  );
  if (answer.state !== "there") return answer;
  const shots = await askJson<ResultDocument>(inUnits(`${answer.value.place}/shots`, system));
  return shots.state === "there" ? { state: "there", value: { source, ...answer.value, shots: shots.value } } : shots;
}

/** Loads the report on the file, once it is looked at. */
export function loadReport({ model, actions, state }: Context): void {
  const { file, report } = model.session;
  if (file.state !== "there" || report.state !== "none" || !claim(actions.session, "report")) return;
  void askText(inUnits(`${file.value.place}/report`, state.system)).then((answer) =>
    actions.session(ifSame(file.value, { report: answer })),
  );
}

/** Estimates the golfer of the file, or of the shots of one club in it. */
export function loadGolfer({ model, actions, state }: Context): void {
  const { file, golfer, wishes } = model.session;
  if (file.state !== "there" || golfer.state !== "none" || !claim(actions.session, "golfer")) return;
  const query = wishes.only ? `?${new URLSearchParams({ only: wishes.only })}` : "";
  void askJson<ResultDocument>(inUnits(`${file.value.place}/golfer${query}`, state.system)).then((answer) =>
    actions.session(ifSame(file.value, { golfer: answer })),
  );
}

/** A change that is made only while the file is still the one that was asked about. */
const ifSame =
  (file: SessionFile, part: Partial<Session>) =>
  (session: Session): Partial<Session> =>
    session.file.state === "there" && session.file.value === file ? part : {};

/** Starts a fitting for the golfer of the file. */
export function startFitting(context: Context): void {
  const { file, wishes } = context.model.session;
  if (file.state !== "there") return;
  const { loft, only, ...rest } = wishes;
  const body = { ...rest, ...(loft ? { loft } : {}), ...(only ? { only } : {}) };
  startJob(context, `${file.value.place}/fittings`, JSON.stringify(body));
}

function startJob(
  { model, actions, state }: Pick<Context, "model" | "actions" | "state">,
  path: string,
  body: BodyInit,
): void {
  const { api } = model.session;
  actions.session(() => ({ fitting: LOADING }));
  void askJson<Job>(inUnits(path, state.system), { method: "POST", body }).then((answer) => {
    actions.session(() => ({
      fitting: answer.state === "there" ? { state: "there", value: { ...answer.value, result: null } } : answer,
    }));
    if (answer.state === "there" && api !== null)
      follow(inUnits(`${api}jobs/${answer.value.job}/events`, state.system), answer.value.job, actions.session);
  });
}

/** Takes the progress of a job until its end. */
function follow(events: string, job: string, set: Set): void {
  const source = new EventSource(events);
  const take = (event: MessageEvent<string>): void =>
    set(({ fitting }) => {
      if (fitting.state !== "there" || fitting.value.job !== job) return {};
      return { fitting: { state: "there", value: { ...fitting.value, ...(JSON.parse(event.data) as Job) } } };
    });
  source.addEventListener("progress", take);
  source.addEventListener("end", (event) => {
    source.close();
    take(event);
  });
}

export function cancelFitting({ model, actions }: Context): void {
  const { api, fitting } = model.session;
  if (api === null || fitting.state !== "there") return;
  const { job } = fitting.value;
  void askJson<Job>(`${api}jobs/${job}`, { method: "DELETE" }).then((answer) => {
    if (answer.state !== "there") actions.session(() => ({ fitting: answer }));
  });
}

async function loadStudies(api: string, set: Set): Promise<void> {
  set(() => ({ studies: LOADING }));
  const studies = await askJson<ResultDocument>(`${api}studies`);
  set(() => ({ studies }));
}

export function openStudy({ model, actions, state }: Context, name: string): void {
  const { api } = model.session;
  if (api === null) return;
  actions.session(() => ({ study: { name, report: LOADING } }));
  void askText(inUnits(`${api}studies/${encodeURIComponent(name)}/report`, state.system)).then((report) =>
    actions.session(({ study }) => (study?.name === name ? { study: { name, report } } : {})),
  );
}

/** Takes live shots as they come; after a break the stream goes on where it was. */
function listen(api: string, set: Set): void {
  set(() => ({ live: initialLive() }));
  const source = new EventSource(`${api}live/events`);
  const isOpen = (isConnected: boolean) => (): void =>
    set(({ live }) => (live && live.isConnected !== isConnected ? { live: { ...live, isConnected } } : {}));
  source.addEventListener("open", isOpen(true));
  source.addEventListener("error", isOpen(false));
  source.addEventListener("shots", (event: MessageEvent<string>) =>
    set(({ live }) => (live ? { live: withShots(live, JSON.parse(event.data) as ResultDocument) } : {})),
  );
  source.addEventListener("state", (event: MessageEvent<string>) =>
    set(({ live }) => (live ? { live: { ...live, state: JSON.parse(event.data) as LiveState } } : {})),
  );
  addEventListener("pagehide", () => source.close());
}

/** Takes another club or hand for the live shots to come, in all tabs. */
export function choosePlayer({ model, actions }: Context, player: Partial<Pick<LiveState, "club" | "hand">>): void {
  const { api } = model.session;
  if (api === null) return;
  const body = JSON.stringify(player);
  void askJson<LiveState>(`${api}live/player`, { method: "POST", body }).then((answer) => {
    if (answer.state === "refused") actions.notice(`${answer.mistake.what}.`);
  });
}
