package arcomat.editor.answer.completion;

import arcomat.editor.desk.View;
import arcomat.editor.foreign.GuestText;
import arcomat.editor.text.Positions;
import arcomat.guest.BehaviourLanguage.Suggestion;
import arcomat.guest.host.Guests;
import arcomat.syntax.Caret;

import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionItemKind;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What could be written at a place: names that fit before keywords, keywords before whole pieces.
 * In a text of a guest's language it is what the guest says.
 */
public final class Completion {
    private Completion() {}

    public static List<CompletionItem> at(View view, int offset) {
        return Caret.at(view.file(), offset).map(caret -> at(view, caret)).orElse(List.of());
    }

    private static List<CompletionItem> at(View view, Caret caret) {
        int offset = caret.written().end();
        Optional<GuestText> foreign = GuestText.around(view, offset);
        if (foreign.isPresent()) {
            return placed(
                    foreign.get().suggestions(view, offset).stream().map(Completion::item).toList(),
                    caret);
        }
        Offers offers = Offers.at(view.file(), WritingPlace.of(view, caret));
        List<CompletionItem> items = new ArrayList<>();
        offers.names().forEach(name -> items.add(item(name)));
        offers.words().forEach(word -> items.add(keyword(word)));
        offers.pieces().forEach(piece -> items.add(CompletionItems.piece(piece)));
        if (offers.isBehaviour()) {
            for (Guests.Language each : view.models().guests().languages()) {
                if (items.stream().noneMatch(item -> item.getLabel().equals(each.keyword()))) {
                    items.add(keyword(each));
                }
            }
        }
        return placed(List.copyOf(items), caret);
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
        item.setKind(CompletionItems.kind(name.kind()));
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
