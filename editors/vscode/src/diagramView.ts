import * as fs from 'node:fs/promises';
import * as os from 'node:os';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { CommandLine, FINE, register } from './commandLine';
import { definitionIn, homeOf, modelRoot, openPlace, saveAll } from './models';
import { inTheme, isDark } from './theme';
import { Assets } from './assets';

const DRAWN = new Set(['arcomat', 'arcomat-automaton', 'arcomat-class-diagram']);

/** The picture of the model in the editor, beside it: drawn anew at each save, marked where the cursor is. */
export function registerDiagram(assets: Assets, tool: CommandLine): vscode.Disposable[] {
  const view = new DiagramView(assets, tool);
  return [
    view,
    register('arcomat.diagram', () => view.open()),
    vscode.workspace.onDidSaveTextDocument((document) => view.saved(document)),
    vscode.window.onDidChangeActiveTextEditor((editor) => view.follow(editor)),
    vscode.window.onDidChangeTextEditorSelection((change) => view.mark(change.textEditor)),
    vscode.window.onDidChangeActiveColorTheme(() => view.draw()),
    vscode.window.registerWebviewPanelSerializer('arcomat.diagram', view),
  ];
}

class DiagramView implements vscode.Disposable, vscode.WebviewPanelSerializer {
  private panel: vscode.WebviewPanel | undefined;
  private document: vscode.TextDocument | undefined;
  private latest = 0;

  constructor(
    private readonly assets: Assets,
    private readonly tool: CommandLine,
  ) {}

  async open(): Promise<void> {
    const document = vscode.window.activeTextEditor?.document;
    if (!document || !DRAWN.has(document.languageId)) {
      void vscode.window.showInformationMessage('Arcomat: open a component, an automaton or a class diagram first.');
      return;
    }
    this.document = document;
    if (!this.panel) {
      const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
      this.adopt(vscode.window.createWebviewPanel('arcomat.diagram', 'Diagram', beside, { enableScripts: true }));
    }
    await saveAll();
    await this.draw();
  }

  /** After the window was loaded again, the view waits for an editor to follow. */
  async deserializeWebviewPanel(panel: vscode.WebviewPanel): Promise<void> {
    this.adopt(panel);
    await this.follow(vscode.window.activeTextEditor);
  }

  private adopt(panel: vscode.WebviewPanel): void {
    this.panel = panel;
    panel.webview.options = { enableScripts: true, localResourceRoots: [] };
    panel.onDidDispose(() => (this.panel = undefined));
    panel.webview.onDidReceiveMessage(async (message: { place?: unknown }) => {
      if (typeof message.place === 'string' && this.document) {
        await openPlace(message.place, homeOf(this.document.uri));
      }
    });
  }

  async follow(editor: vscode.TextEditor | undefined): Promise<void> {
    const document = editor?.document;
    if (this.panel && document && document !== this.document && DRAWN.has(document.languageId)) {
      this.document = document;
      await this.draw();
    }
  }

  async saved(document: vscode.TextDocument): Promise<void> {
    if (document.languageId.startsWith('arcomat')) {
      await this.draw();
    }
  }

  /** Says on which line the cursor is; the page knows which part that is. */
  mark(editor: vscode.TextEditor): void {
    if (this.panel && editor.document === this.document) {
      const line = editor.selection.active.line + 1;
      void this.panel.webview.postMessage({ file: editor.document.uri.fsPath, line });
    }
  }

  async draw(): Promise<void> {
    const { panel, document } = this;
    if (!panel || !document) {
      return;
    }
    const number = ++this.latest;
    const drawn = await this.pictures(document);
    if (number === this.latest && this.panel === panel) {
      panel.title = `Diagram: ${path.parse(document.fileName).name}`;
      panel.webview.html = await this.assets.page(inTheme(drawn, isDark()), 'diagram.css', ['clicks.js', 'cursor.js']);
      vscode.window.visibleTextEditors.filter((each) => each.document === document).forEach((each) => this.mark(each));
    }
  }

  /** What the command draws of one file; what it says instead, where models have errors. */
  private async pictures(document: vscode.TextDocument): Promise<string> {
    const parent = await fs.mkdtemp(path.join(os.tmpdir(), 'arcomat-diagram-'));
    try {
      const folder = path.join(parent, 'pictures');
      const outcome = await this.tool.run(['diagram', '--out', folder, ...subject(document)], homeOf(document.uri));
      return outcome.status === FINE ? await joined(folder) : refusal(outcome.out + outcome.err);
    } finally {
      await fs.rm(parent, { recursive: true, force: true });
    }
  }

  dispose(): void {
    this.panel?.dispose();
  }
}

/** One component of its model root, so that what it refers to is found; a class diagram alone. */
function subject(document: vscode.TextDocument): string[] {
  const definition = definitionIn(document.uri, document.getText());
  return definition
    ? ['--component', definition.qualifiedName, modelRoot(document.uri, document.getText())]
    : [document.uri.fsPath];
}

async function joined(folder: string): Promise<string> {
  const files = (await fs.readdir(folder)).filter((name) => name.endsWith('.svg')).sort();
  const pictures = await Promise.all(files.map((name) => fs.readFile(path.join(folder, name), 'utf8')));
  return pictures.join('\n');
}

function refusal(text: string): string {
  const plain = text.replace(/&/g, '&amp;').replace(/</g, '&lt;');
  return `<p class="refused">No picture is drawn while the models have errors.</p><pre>${plain}</pre>`;
}
