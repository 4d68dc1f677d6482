import * as path from 'node:path';
import * as vscode from 'vscode';
import { CommandLine, FINE, register } from './commandLine';
import { homeOf, modelRoot, saveAll, shownOrPicked, textOf, withArguments } from './models';
import { ReportPages } from './reportPages';

/** Commands that make models and run them. */
export function registerModelCommands(tool: CommandLine, pages: ReportPages): vscode.Disposable[] {
  return [
    register('arcomat.new', () => create(tool)),
    register('arcomat.simulate', () => simulate(pages)),
    register('arcomat.world', () => play('World', 'world', '.world', pages)),
    register('arcomat.campaign', () => play('Campaign', 'campaign', '.campaign', pages)),
  ];
}

const KINDS: readonly (vscode.QuickPickItem & { word: string })[] = [
  { word: 'robot', label: 'Robot', description: 'a program for the brick, what it promises, tests, a world' },
  { word: 'component', label: 'Component', description: 'the logic alone' },
  { word: 'world', label: 'World', description: 'two robots on one floor, and a campaign' },
];

async function create(tool: CommandLine): Promise<void> {
  const kind = await vscode.window.showQuickPick(KINDS, { title: 'What shall it be?' });
  const name = kind && (await vscode.window.showInputBox({ title: 'Its name', value: 'mower', ignoreFocusOut: true }));
  const parent = name && (await chooseFolder());
  if (!kind || !name || !parent) {
    return;
  }
  const outcome = await tool.show(`Making ${name}`, ['new', name, '--kind', kind.word], parent);
  if (outcome?.status === FINE) {
    await offer(path.join(parent, name));
  } else if (outcome) {
    await tool.tell(outcome);
  }
}

/** The only folder that is open, else one that is asked for. */
async function chooseFolder(): Promise<string | undefined> {
  const folders = vscode.workspace.workspaceFolders ?? [];
  if (folders.length === 1 && folders[0]) {
    return folders[0].uri.fsPath;
  }
  const chosen = await vscode.window.showOpenDialog({
    title: 'The folder to make it in',
    canSelectFiles: false,
    canSelectFolders: true,
  });
  return chosen?.[0]?.fsPath;
}

/** What is made within the workspace is shown there, else it can become the workspace. */
async function offer(folder: string): Promise<void> {
  const uri = vscode.Uri.file(folder);
  if (vscode.workspace.getWorkspaceFolder(uri)) {
    await vscode.commands.executeCommand('revealInExplorer', vscode.Uri.file(path.join(folder, 'README.md')));
    await vscode.commands.executeCommand('vscode.open', vscode.Uri.file(path.join(folder, 'README.md')));
  } else {
    await vscode.commands.executeCommand('vscode.openFolder', uri);
  }
}

async function simulate(pages: ReportPages): Promise<void> {
  const definition = await shownOrPicked('Which component is to run?');
  const component = definition && (await withArguments(definition));
  if (!definition || !component) {
    return;
  }
  await saveAll();
  const slices = vscode.workspace.getConfiguration('arcomat').get<number>('slices', 20);
  const root = modelRoot(definition.file, await textOf(definition.file));
  const words = ['simulate', '--main', component, '--slices', String(slices), root];
  await pages.run(`Run: ${definition.qualifiedName}`, 'simulate', words, homeOf(definition.file));
}

/** A world or a campaign: the file of the editor. */
async function play(title: string, command: string, end: string, pages: ReportPages): Promise<void> {
  const file = vscode.window.activeTextEditor?.document.uri;
  if (!file?.fsPath.endsWith(end)) {
    void vscode.window.showInformationMessage(`Arcomat: open a file that ends in ${end} first.`);
    return;
  }
  await saveAll();
  const name = path.basename(file.fsPath, end);
  await pages.run(`${title}: ${name}`, command, [command, file.fsPath], homeOf(file));
}
