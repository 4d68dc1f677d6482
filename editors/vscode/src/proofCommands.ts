import * as fs from 'node:fs/promises';
import * as os from 'node:os';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { CommandLine, FINE, Outcome, register, run } from './commandLine';
import { homeOf, modelRoot, pickComponent, saveAll, shownOrPicked, shownOrPickedRoot, textOf } from './models';
import { ReportPages } from './reportPages';

/** Commands that prove. */
export function registerProofCommands(tool: CommandLine, pages: ReportPages): vscode.Disposable[] {
  return [
    register('arcomat.refines', () => refines(pages)),
    register('arcomat.verify', () => verify(pages)),
    register('arcomat.gate', () => gate(tool)),
  ];
}

async function refines(pages: ReportPages): Promise<void> {
  const newer = await shownOrPicked('Which component is to keep the promises?');
  const older = newer && (await pickComponent(`Which promises does ${newer.qualifiedName} have to keep?`));
  if (!newer || !older) {
    return;
  }
  await saveAll();
  const roots = new Set([await rootOf(newer.file), await rootOf(older.file)]);
  const words = ['refines', newer.qualifiedName, older.qualifiedName, ...roots];
  await pages.run(`${newer.qualifiedName} refines ${older.qualifiedName}?`, 'refines', words, homeOf(newer.file));
}

async function rootOf(file: vscode.Uri): Promise<string> {
  return modelRoot(file, await textOf(file));
}

async function verify(pages: ReportPages): Promise<void> {
  const root = await shownOrPickedRoot('The promises of which models?');
  if (root) {
    await saveAll();
    await pages.run('Promises', 'verify', ['verify', root], homeOf(vscode.Uri.file(root)));
  }
}

/** Compares with a commit, which is checked out beside for as long as it takes. */
async function gate(tool: CommandLine): Promise<void> {
  const root = await shownOrPickedRoot('The promises of which models?');
  const commit = root && (await vscode.window.showInputBox({
    title: 'With which commit, branch or tag are promises compared?',
    value: 'main',
    ignoreFocusOut: true,
  }));
  if (!root || !commit) {
    return;
  }
  await saveAll();
  const top = await git(['rev-parse', '--show-toplevel'], root);
  if (top.status !== FINE) {
    void vscode.window.showErrorMessage(`Arcomat: ${root} lies in no repository of git, so there is nothing to compare with.`);
    return;
  }
  await compare(tool, commit, root, top.out.trim());
}

async function compare(tool: CommandLine, commit: string, root: string, top: string): Promise<void> {
  const parent = await fs.mkdtemp(path.join(os.tmpdir(), 'arcomat-gate-'));
  const checkout = path.join(parent, 'base');
  try {
    const made = await git(['worktree', 'add', '--detach', checkout, commit], top);
    if (made.status !== FINE) {
      void vscode.window.showErrorMessage(`Arcomat: git knows no commit '${commit}': ${made.err.trim()}`);
      return;
    }
    const base = path.join(checkout, path.relative(top, await fs.realpath(root)));
    const outcome = await tool.show(`Comparing with ${commit}`, ['gate', '--base', base, root], top);
    if (outcome) {
      await tool.tell(outcome);
    }
  } finally {
    await git(['worktree', 'remove', '--force', checkout], top);
    await fs.rm(parent, { recursive: true, force: true });
  }
}

function git(words: readonly string[], folder: string): Promise<Outcome> {
  return run('git', words, folder);
}
