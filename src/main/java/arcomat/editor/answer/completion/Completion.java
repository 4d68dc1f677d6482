package arcomat.editor.answer.completion;

import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.syntax.Caret;
import arcomat.syntax.Continuations;

import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionItemKind;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What could be written at a place: names that fit before keywords, keywords before whole pieces.
 */
public final class Completion {
    /** What the grammar takes for the sake of old models, and nobody should begin with. */
    private static final Set<String> OUTDATED =
            Set.of(
                    "boolean", "byte", "call", "char", "double", "float", "int", "long", "new",
                    "null", "short");

    private Completion() {}

    public static List<CompletionItem> at(View view, int offset) {
        return Caret.at(view.file(), offset).map(caret -> at(view, caret)).orElse(List.of());
    }

    private static List<CompletionItem> at(View view, Caret caret) {
        Continuations possible = Continuations.at(caret, view.file());
        Map<String, CompletionItem> items = new LinkedHashMap<>();
        KnownNames known = new KnownNames(WritingPlace.of(view, caret));
        possible.names().stream()
                .flatMap(rules -> known.at(rules).stream())
                .forEach(name -> items.putIfAbsent(name.label(), item(name)));
        for (String word : possible.words()) {
            if (!OUTDATED.contains(word)) {
                items.putIfAbsent(word, keyword(word));
            }
        }
        for (Skeleton skeleton : Skeleton.ALL) {
            if (skeleton.fits(possible)) {
                items.putIfAbsent(skeleton.label(), skeleton.item());
            }
        }
        Range typed = Positions.range(caret.typed());
        items.values().forEach(item -> place(item, typed));
        return List.copyOf(items.values());
    }

    private static CompletionItem item(Proposal name) {
        CompletionItem item = new CompletionItem(name.label());
        item.setKind(name.kind());
        item.setDetail(name.detail());
        item.setSortText("1" + name.label());
        item.setAdditionalTextEdits(
                name.needed().stream()
                        .map(edit -> new TextEdit(Positions.range(edit.span()), edit.text()))
                        .toList());
        return item;
    }

    private static CompletionItem keyword(String word) {
        CompletionItem item = new CompletionItem(word);
        item.setKind(CompletionItemKind.Keyword);
        item.setSortText("2" + word);
        return item;
    }

    /** In the place of the word that is being typed, whatever an editor takes for a word. */
    private static void place(CompletionItem item, Range typed) {
        String text = item.getInsertText() == null ? item.getLabel() : item.getInsertText();
        item.setTextEdit(Either.forLeft(new TextEdit(typed, text)));
        item.setInsertText(null);
    }
}
