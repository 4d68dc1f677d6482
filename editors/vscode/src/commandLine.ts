import { spawn } from 'node:child_process';
import * as os from 'node:os';
import * as path from 'node:path';
import * as vscode from 'vscode';

/** What a command came to: its exit status and what it wrote. */
export interface Outcome {
  readonly status: number;
  readonly out: string;
  readonly err: string;
}

/** Exit statuses of the command line. */
export const FINE = 0;
export const FINDINGS = 1;
export const WRONG_USE = 2;
export const UNKNOWN = 3;

/** Commands that read models. */
const READING = new Set([
  'campaign', 'check', 'diagram', 'gate', 'generate', 'refines', 'run-brick', 'simulate', 'test', 'verify', 'world',
]);

/** The program is not there. */
export class NotFound extends Error {}

/** The command line `arcomat`, where the setting says that it lies. */
export class CommandLine {
  constructor(private readonly output: vscode.OutputChannel) {}

  get program(): string {
    const setting = vscode.workspace.getConfiguration('arcomat').get<string>('path', 'arcomat').trim();
    return setting.startsWith('~/') ? path.join(os.homedir(), setting.slice(2)) : setting || 'arcomat';
  }

  /** Model roots of others, where they lie; relative ones start in the first folder of the workspace. */
  get libraries(): string[] {
    const home = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath ?? os.homedir();
    const setting = vscode.workspace.getConfiguration('arcomat').get<string[]>('libraries', []);
    return setting.filter((each) => each.trim()).map((each) => path.resolve(home, each));
  }

  /** The words of a command, which is told of models of others where it reads models. */
  withLibraries(words: readonly string[]): string[] {
    const command = words[0];
    return command !== undefined && READING.has(command)
      ? [command, ...this.libraries.flatMap((each) => ['--library', each]), ...words.slice(1)]
      : [...words];
  }

  /** Runs a command silently, to its end or until somebody cancels it. */
  run(words: readonly string[], folder: string, cancelled?: vscode.CancellationToken): Promise<Outcome> {
    return run(this.program, this.withLibraries(words), folder, cancelled);
  }

  /** Runs a command with a note that it runs, and keeps what it says in the output. */
  async show(title: string, words: readonly string[], folder: string): Promise<Outcome | undefined> {
    const outcome = await vscode.window.withProgress(
      { location: vscode.ProgressLocation.Notification, title, cancellable: true },
      async (_, cancelled) => {
        const result = await this.run(words, folder, cancelled);
        return cancelled.isCancellationRequested ? undefined : result;
      },
    );
    if (outcome) {
      this.output.appendLine(`$ arcomat ${words.join(' ')}`);
      this.output.appendLine(`${outcome.out}${outcome.err}`);
    }
    return outcome;
  }

  /** Tells in a line what a command found; the rest is in the output. */
  async tell(outcome: Outcome): Promise<void> {
    const line = headline(outcome);
    const more = 'Show Output';
    const answer = outcome.status === FINE
      ? await vscode.window.showInformationMessage(line, more)
      : outcome.status === WRONG_USE
        ? await vscode.window.showErrorMessage(line, more)
        : await vscode.window.showWarningMessage(line, more);
    if (answer === more) {
      this.output.show();
    }
  }

  /** The version, or nothing where there is no such program. */
  async version(): Promise<string | undefined> {
    try {
      const outcome = await this.run(['--version'], os.homedir());
      return outcome.status === FINE ? outcome.out.trim() : undefined;
    } catch (e) {
      if (e instanceof NotFound) {
        return undefined;
      }
      throw e;
    }
  }
}

/** The line that says most: the answer to a question or the first error, else the last line, which sums up. */
function headline(outcome: Outcome): string {
  const wrong = outcome.status === WRONG_USE && outcome.err.trim() !== '';
  const lines = (wrong ? outcome.err : outcome.out || outcome.err).split('\n').filter((line) => line.trim());
  const first = lines[0] ?? 'Nothing was said.';
  return wrong || ANSWER.test(first) ? first : (lines[lines.length - 1] ?? first);
}

const ANSWER = /^(?:holds|fails|unknown)\b/;

export function run(
  program: string,
  words: readonly string[],
  folder: string,
  cancelled?: vscode.CancellationToken,
): Promise<Outcome> {
  return new Promise((resolve, reject) => {
    const child = spawn(program, words, { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
    const stop = cancelled?.onCancellationRequested(() => child.kill());
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    child.stdout.on('data', (bytes: Buffer) => out.push(bytes));
    child.stderr.on('data', (bytes: Buffer) => err.push(bytes));
    child.on('error', (e: NodeJS.ErrnoException) => {
      stop?.dispose();
      reject(e.code === 'ENOENT' ? new NotFound(`'${program}' is not there`) : e);
    });
    child.on('close', (status) => {
      stop?.dispose();
      resolve({
        status: status ?? WRONG_USE,
        out: Buffer.concat(out).toString('utf8'),
        err: Buffer.concat(err).toString('utf8'),
      });
    });
  });
}

/** Runs a command of the palette; a missing program is told with the setting that mends it. */
export function register(id: string, action: (...given: unknown[]) => Promise<void>): vscode.Disposable {
  return vscode.commands.registerCommand(id, async (...given: unknown[]) => {
    try {
      await action(...given);
    } catch (e) {
      if (!(e instanceof NotFound)) {
        throw e;
      }
      await tellMissing(e.message);
    }
  });
}

export async function tellMissing(reason: string): Promise<void> {
  const open = 'Open Setting';
  const answer = await vscode.window.showErrorMessage(
    `Arcomat: ${reason}. Put arcomat on the path, or say in the setting arcomat.path where it lies.`,
    open,
  );
  if (answer === open) {
    await vscode.commands.executeCommand('workbench.action.openSettings', 'arcomat.path');
  }
}
