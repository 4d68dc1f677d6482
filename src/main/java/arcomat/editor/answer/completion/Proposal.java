package arcomat.editor.answer.completion;

import arcomat.source.Fix.TextEdit;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;

import org.eclipse.lsp4j.CompletionItemKind;

import java.util.List;

/**
 * A name that fits.
 *
 * @param label the name
 * @param kind for the picture that editors put before it
 * @param detail what it is, in a few words
 * @param needed edits elsewhere that it needs: an import
 */
record Proposal(String label, CompletionItemKind kind, String detail, List<TextEdit> needed) {
    static Proposal of(String label, CompletionItemKind kind, String detail) {
        return new Proposal(label, kind, detail, List.of());
    }

    static Proposal of(PortSymbol port) {
        String direction = port.isInput() ? "in " : "out ";
        return of(port.name(), CompletionItemKind.Interface, direction + port.type().text());
    }

    static Proposal of(ValueSymbol value) {
        return value instanceof PortSymbol port
                ? of(port)
                : of(value.name(), CompletionItemKind.Variable, value.type().text());
    }

    static Proposal of(InstanceSymbol part) {
        String component = part.component().map(each -> each.qualifiedName()).orElse("");
        return of(part.name(), CompletionItemKind.Module, component);
    }
}
