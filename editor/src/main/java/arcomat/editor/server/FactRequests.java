package arcomat.editor.server;

import arcomat.editor.answer.fact.HoverCard;
import arcomat.editor.answer.fact.InlineFacts;
import arcomat.editor.answer.fact.ParameterHelp;

import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.InlayHintParams;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.SignatureHelp;
import org.eclipse.lsp4j.SignatureHelpOptions;
import org.eclipse.lsp4j.SignatureHelpParams;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/** What editors ask in order to show it beside a text. */
abstract class FactRequests extends ShapeRequests {
    FactRequests(Worker worker) {
        super(worker);
    }

    static void announce(ServerCapabilities can) {
        ShapeRequests.announce(can);
        can.setHoverProvider(true);
        can.setSignatureHelpProvider(new SignatureHelpOptions(List.of("(", ",")));
        can.setInlayHintProvider(true);
    }

    @Override
    public CompletableFuture<Hover> hover(HoverParams params) {
        return askOne(params.getTextDocument(), view -> HoverCard.at(view, params.getPosition()));
    }

    @Override
    public CompletableFuture<SignatureHelp> signatureHelp(SignatureHelpParams params) {
        return askOne(
                params.getTextDocument(),
                view ->
                        view.reader().isPresent()
                                ? Optional.empty()
                                : ParameterHelp.at(view, view.offset(params.getPosition())));
    }

    @Override
    public CompletableFuture<List<InlayHint>> inlayHint(InlayHintParams params) {
        return askOwn(params.getTextDocument(), view -> InlineFacts.in(view, params.getRange()));
    }
}
