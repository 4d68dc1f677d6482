import * as vscode from 'vscode';
import {
  LanguageClient,
  LanguageClientOptions,
  ShowDocumentParams,
  ShowDocumentRequest,
  ShowDocumentResult,
} from 'vscode-languageclient/node';
import { CommandLine, tellMissing } from './commandLine';
import { LANGUAGES } from './models';
import { ReportPages } from './reportPages';

const NEVER = new vscode.CancellationTokenSource().token;

/** `arcomat language-server`, which finds, mends, completes, renames and formats. */
export class LanguageServer implements vscode.Disposable {
  private client: LanguageClient | undefined;

  constructor(
    private readonly tool: CommandLine,
    private readonly output: vscode.OutputChannel,
    private readonly pages: ReportPages,
  ) {}

  async start(): Promise<void> {
    const version = await this.tool.version();
    await vscode.commands.executeCommand('setContext', 'arcomat.found', version !== undefined);
    if (version === undefined) {
      void tellMissing(`'${this.tool.program}' is not there, or is no Arcomat`);
      return;
    }
    this.output.appendLine(version);
    const client = new LanguageClient('arcomat', 'Arcomat', this.server(), this.options());
    this.client = client;
    await client.start();
  }

  private server(): { command: string; args: string[] } {
    return { command: this.tool.program, args: ['language-server'] };
  }

  private options(): LanguageClientOptions {
    return {
      documentSelector: [...new Set(Object.values(LANGUAGES))].map((language) => ({ scheme: 'file', language })),
      outputChannel: this.output,
      initializationOptions: () => ({ libraries: this.tool.libraries }),
      synchronize: { configurationSection: 'arcomat' },
      middleware: { window: { showDocument: (asked, next) => this.show(asked, next) } },
    };
  }

  /** A page goes to a side view: as a text, nobody could read it. */
  private async show(asked: ShowDocumentParams, next: ShowDocumentRequest.HandlerSignature): Promise<ShowDocumentResult> {
    const uri = vscode.Uri.parse(asked.uri);
    if (uri.scheme !== 'file' || !uri.path.endsWith('.html')) {
      return (await next(asked, NEVER)) as ShowDocumentResult;
    }
    const home = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath ?? '';
    await this.pages.showFile('Verdict', 'verdict', uri.fsPath, home);
    return { success: true };
  }

  async restart(): Promise<void> {
    const old = this.client;
    this.client = undefined;
    await old?.dispose();
    await this.start();
  }

  dispose(): void {
    void this.client?.dispose();
  }
}
