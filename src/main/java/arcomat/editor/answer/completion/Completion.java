package arcomat.editor.answer.completion;

import arcomat.editor.desk.View;
import arcomat.editor.foreign.GuestText;
import arcomat.editor.text.Positions;
import arcomat.guest.BehaviourLanguage.Suggestion;
import arcomat.guest.host.Guests;
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
import java.util.Optional;
import java.util.Set;

/**
 * What could be written at a place: names that fit before keywords, keywords before whole pieces.
 * In a text of a guest's language it is what the guest says.
 */
public final class Completion {
    /** What the grammar takes for the sake of old models, and nobody should begin with. */
    private static final Set<String> OUTDATED =
            Set.of(
                    "boolean", "byte", "call", "char", "double", "float", "int", "long", "new",
                    "null", "short");

    /** A word that behaviours begin with, and only behaviours of components. */
    private static final String BEHAVIOUR = "table";

    private Completion() {}

    public static List<CompletionItem> at(View view, int offset) {
        return Caret.at(view.file(), offset).map(caret -> at(view, caret)).orElse(List.of());
    }

    private static List<CompletionItem> at(View view, Caret caret) {
        int offset = caret.written().end();
        Optional<GuestText> foreign = GuestText.around(view, offset);
        if (foreign.isPresent()) {
            return placed(
                    foreign.get().suggestions(offset).stream().map(Completion::item).toList(),
                    caret);
        }
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
        if (possible.words().contains(BEHAVIOUR)) {
            for (Guests.Language each : view.models().guests().languages()) {
                items.putIfAbsent(each.keyword(), keyword(each));
            }
        }
        return placed(List.copyOf(items.values()), caret);
    }

    private static List<CompletionItem> placed(List<CompletionItem> items, Caret caret) {
        Range typed = Positions.range(caret.typed());
        items.forEach(item -> place(item, typed));
        return items;
    }

    private static CompletionItem keyword(Guests.Language language) {
        CompletionItem item = keyword(language.keyword());
        item.setDetail(
                language.words().getOrDefault(language.keyword(), "guest " + language.guest()));
        return item;
    }

    private static CompletionItem item(Suggestion suggestion) {
        CompletionItem item = keyword(suggestion.text());
        item.setDetail(suggestion.what());
        return item;
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
