import * as path from 'node:path';
import * as vscode from 'vscode';

/** Ids of the languages, by the ends of their files. */
export const LANGUAGES: Readonly<Record<string, string>> = {
  '.arc': 'arcomat',
  '.cd': 'arcomat-class-diagram',
  '.ioautomaton': 'arcomat-automaton',
  '.maa': 'arcomat',
  '.mt': 'arcomat-stream-test',
  '.world': 'arcomat-world',
  '.script': 'arcomat-script',
  '.campaign': 'arcomat-campaign',
};

/** What builds have made: copies of models in there are nobody's to look at. */
export const MADE = '**/{build,target,node_modules}/**';

const NAME = '[\\p{L}_$][\\p{L}\\p{N}_$]*';
const PACKAGE = new RegExp(`^\\s*package\\s+(${NAME}(?:\\s*\\.\\s*${NAME})*)\\s*;`, 'mu');

/** A component that commands can be asked about. */
export interface Definition {
  readonly qualifiedName: string;
  readonly file: vscode.Uri;
  /** What its parameters are written like, if it has some. */
  readonly parameters: string | undefined;
}

/** The text without its comments; what remains stands where it stood. */
export function withoutComments(text: string): string {
  return text.replace(/\/\*[\s\S]*?(?:\*\/|$)|\/\/[^\n]*|"(?:[^"\\\n]|\\.)*"/g, (part) =>
    part.startsWith('/') ? part.replace(/[^\n]/g, ' ') : part,
  );
}

function packageName(text: string): string {
  return (PACKAGE.exec(withoutComments(text))?.[1] ?? '').replace(/\s/g, '');
}

/** The folder that packages are counted from. */
export function modelRoot(file: vscode.Uri, text: string): string {
  const folder = path.dirname(file.fsPath);
  const names = packageName(text).split('.').filter((name) => name);
  const tail = names.join(path.sep);
  return tail && folder.endsWith(path.sep + tail) ? folder.slice(0, -tail.length - 1) : folder;
}

export async function textOf(file: vscode.Uri): Promise<string> {
  return (await vscode.workspace.openTextDocument(file)).getText();
}

export function definitionIn(file: vscode.Uri, text: string): Definition | undefined {
  const name = path.parse(file.fsPath).name;
  const plain = withoutComments(text);
  const header = new RegExp(
    `\\b(?:component|automaton|classdiagram)\\s+${escaped(name)}(?![\\p{L}\\p{N}_$])\\s*(?:\\(([^)]*)\\))?`,
    'u',
  );
  const found = header.exec(plain);
  const home = packageName(text);
  return found
    ? { qualifiedName: home ? `${home}.${name}` : name, file, parameters: found[1]?.trim() }
    : undefined;
}

function escaped(name: string): string {
  return name.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
}

/** All components of the workspace, by name. */
async function definitions(): Promise<Definition[]> {
  const files = await vscode.workspace.findFiles('**/*.{arc,ioautomaton,maa}', MADE);
  const found = await Promise.all(files.map(async (file) => definitionIn(file, await readQuietly(file))));
  return found
    .filter((each): each is Definition => each !== undefined)
    .sort((a, b) => a.qualifiedName.localeCompare(b.qualifiedName));
}

/** Without opening it, which would tell every extension of each file. */
async function readQuietly(file: vscode.Uri): Promise<string> {
  const open = vscode.workspace.textDocuments.find((document) => document.uri.toString() === file.toString());
  return open ? open.getText() : Buffer.from(await vscode.workspace.fs.readFile(file)).toString('utf8');
}

interface DefinitionPick extends vscode.QuickPickItem {
  readonly definition: Definition;
}

/** Asks for a component; that of the editor stands first. */
export async function pickComponent(title: string): Promise<Definition | undefined> {
  const shown = vscode.window.activeTextEditor?.document.uri.toString();
  const picks: DefinitionPick[] = (await definitions())
    .sort((a, b) => Number(b.file.toString() === shown) - Number(a.file.toString() === shown))
    .map((definition) => ({
      label: definition.qualifiedName,
      description: vscode.workspace.asRelativePath(definition.file),
      definition,
    }));
  if (picks.length === 0) {
    void vscode.window.showWarningMessage('Arcomat: no folder that is open here has a component.');
    return undefined;
  }
  return (await vscode.window.showQuickPick(picks, { title, matchOnDescription: true }))?.definition;
}

/** The component of the editor, else one that is asked for. */
export async function shownOrPicked(title: string): Promise<Definition | undefined> {
  const document = vscode.window.activeTextEditor?.document;
  const shown = document && isComponentFile(document) ? definitionIn(document.uri, document.getText()) : undefined;
  return shown ?? pickComponent(title);
}

function isComponentFile(document: vscode.TextDocument): boolean {
  return document.languageId === 'arcomat' || document.languageId === 'arcomat-automaton';
}

/** A component as commands call it: with its arguments, which are asked for where it takes some. */
export async function withArguments(definition: Definition): Promise<string | undefined> {
  if (!definition.parameters) {
    return definition.qualifiedName;
  }
  const given = await vscode.window.showInputBox({
    title: definition.qualifiedName,
    prompt: `Its arguments, separated by commas: ${definition.parameters}`,
    ignoreFocusOut: true,
  });
  return given === undefined ? undefined : given ? `${definition.qualifiedName}(${given})` : definition.qualifiedName;
}

/** The model root of the editor, else the only one, else one that is asked for. */
export async function shownOrPickedRoot(title: string): Promise<string | undefined> {
  const document = vscode.window.activeTextEditor?.document;
  if (document && document.languageId in byLanguage) {
    return modelRoot(document.uri, document.getText());
  }
  const files = await vscode.workspace.findFiles('**/*.{arc,ioautomaton,maa,cd}', MADE);
  const roots = [...new Set(await Promise.all(files.map(async (file) => modelRoot(file, await readQuietly(file)))))].sort();
  return roots.length > 1 ? vscode.window.showQuickPick(roots, { title }) : roots[0];
}

const byLanguage: Readonly<Record<string, true>> = {
  'arcomat': true,
  'arcomat-automaton': true,
  'arcomat-class-diagram': true,
  'arcomat-stream-test': true,
};

/** The folder that commands run in, so that what they print is short. */
export function homeOf(file: vscode.Uri): string {
  return vscode.workspace.getWorkspaceFolder(file)?.uri.fsPath ?? path.dirname(file.fsPath);
}

/** Commands read what is on the disk. */
export async function saveAll(): Promise<void> {
  const ours = vscode.workspace.textDocuments.filter(
    (document) => document.isDirty && document.languageId.startsWith('arcomat'),
  );
  await Promise.all(ours.map((document) => document.save()));
}

/** Shows a place as the tool writes it: a path and a line, from 1. */
export async function openPlace(place: string, folder: string): Promise<void> {
  const parts = /^(.*?):(\d+)(?::\d+)?$/.exec(place);
  if (!parts) {
    return;
  }
  const file = vscode.Uri.file(path.resolve(folder, parts[1] ?? ''));
  const line = Math.max(0, Number(parts[2]) - 1);
  try {
    const document = await vscode.workspace.openTextDocument(file);
    const at = new vscode.Range(line, 0, line, 0);
    await vscode.window.showTextDocument(document, { selection: at, viewColumn: vscode.ViewColumn.One });
  } catch {
    void vscode.window.showInformationMessage(`${place} is a model of the library, and no file here.`);
  }
}
