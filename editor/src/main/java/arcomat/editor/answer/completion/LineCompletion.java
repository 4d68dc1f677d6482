package arcomat.editor.answer.completion;

import arcomat.editor.text.Positions;
import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.BesideText.Choice;
import arcomat.source.SourceFile;

import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionItemKind;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.util.ArrayList;
import java.util.List;

/** {@link LineOffers} as the protocol has them. */
public final class LineCompletion {
    private LineCompletion() {}

    /**
     * @param file the text as it is on the screen
     */
    public static List<CompletionItem> at(BesideText text, SourceFile file, int offset) {
        LineOffers offers = LineOffers.at(file, offset, text.choices(offset));
        List<CompletionItem> items = new ArrayList<>();
        offers.choices().forEach(each -> items.add(item(each)));
        offers.pieces().forEach(piece -> items.add(CompletionItems.piece(piece)));
        Range typed = Positions.range(offers.typed());
        items.forEach(item -> place(item, typed));
        return items;
    }

    private static CompletionItem item(Choice choice) {
        CompletionItem item = new CompletionItem(choice.word());
        item.setKind(choice.isWord() ? CompletionItemKind.Keyword : CompletionItemKind.Reference);
        if (!choice.isWord()) {
            item.setDetail(choice.what());
        }
        return item;
    }

    /** In the place of the word that is being typed. */
    private static void place(CompletionItem item, Range typed) {
        String text = item.getInsertText() == null ? item.getLabel() : item.getInsertText();
        item.setTextEdit(Either.forLeft(new TextEdit(typed, text)));
        item.setInsertText(null);
    }
}
