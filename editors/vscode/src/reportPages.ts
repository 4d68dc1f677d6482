import * as fs from 'node:fs/promises';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { CommandLine, FINE, Outcome } from './commandLine';
import { openPlace } from './models';
import { Assets, hash } from './assets';
import { inTheme, isDark } from './theme';

/** Pages that commands write by `--report`, shown beside the text. */
export class ReportPages {
  private readonly panels = new Map<string, vscode.WebviewPanel>();

  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly assets: Assets,
    private readonly tool: CommandLine,
  ) {}

  /** A folder for what a command writes, kept until it writes again. */
  async folder(name: string): Promise<string> {
    const storage = this.context.storageUri ?? this.context.globalStorageUri;
    const folder = path.join(storage.fsPath, name);
    await fs.mkdir(path.dirname(folder), { recursive: true });
    return folder;
  }

  /**
   * Runs a command that can write a page, and shows the page. What went well is on it; else a line tells what is wrong.
   *
   * @param home that it runs in; paths below it are told from there
   */
  async run(title: string, name: string, words: readonly string[], home: string): Promise<Outcome | undefined> {
    const folder = await this.folder(name);
    await fs.rm(path.join(folder, 'index.html'), { force: true });
    const short = words.map((word) => (word.startsWith(home + path.sep) ? path.relative(home, word) : word));
    const outcome = await this.tool.show(title, [...short, '--report', folder], home);
    if (outcome) {
      await this.show(title, name, folder, home);
    }
    if (outcome && outcome.status !== FINE) {
      void this.tool.tell(outcome);
    }
    return outcome;
  }

  /** Shows the page of a folder, if there is one. */
  async show(title: string, name: string, folder: string, home: string): Promise<void> {
    await this.showFile(title, name, path.join(folder, 'index.html'), home);
  }

  /** Shows a page, if it is there. */
  async showFile(title: string, name: string, file: string, home: string): Promise<void> {
    const page = await read(file);
    if (page !== undefined) {
      const panel = this.panel(title, name, home);
      panel.title = title;
      panel.webview.html = dressed(page, await this.assets.text('clicks.js'), isDark());
      panel.reveal(undefined, true);
    }
  }

  private panel(title: string, name: string, home: string): vscode.WebviewPanel {
    const known = this.panels.get(name);
    if (known) {
      return known;
    }
    const panel = vscode.window.createWebviewPanel(
      'arcomat.page',
      title,
      { viewColumn: besideText(), preserveFocus: true },
      { enableScripts: true, localResourceRoots: [], retainContextWhenHidden: true },
    );
    panel.webview.onDidReceiveMessage((message: { place?: unknown }) => {
      if (typeof message.place === 'string') {
        void openPlace(message.place, home);
      }
    });
    panel.onDidDispose(() => this.panels.delete(name));
    this.panels.set(name, panel);
    return panel;
  }
}

/** Where a page is in front already, the next one comes there, too. */
function besideText(): vscode.ViewColumn {
  return vscode.window.activeTextEditor ? vscode.ViewColumn.Beside : vscode.ViewColumn.Active;
}

async function read(file: string): Promise<string | undefined> {
  try {
    return await fs.readFile(file, 'utf8');
  } catch {
    return undefined;
  }
}

/**
 * A page in the theme of the editor, with clicks that lead to the text. Its policy names style and script by their
 * hashes, and goes on to do so: nothing else of it runs.
 */
function dressed(page: string, script: string, dark: boolean): string {
  const style = /<style>([\s\S]*?)<\/style>/.exec(page)?.[1] ?? '';
  const themed = inTheme(style, dark);
  return page
    .replace(style, () => themed)
    .replace(hash(style), hash(themed))
    .replace("script-src '", `script-src '${hash(script)}' '`)
    .replace('</body>', () => `<script>${script}</script></body>`);
}
