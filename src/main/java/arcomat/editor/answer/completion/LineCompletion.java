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

/**
 * What could be written at a place of a world, a campaign or a script: names and words, and at the
 * beginning of a line whole pieces.
 */
public final class LineCompletion {
    private LineCompletion() {}

    /**
     * @param file the text as it is on the screen
     */
    public static List<CompletionItem> at(BesideText text, SourceFile file, int offset) {
        SourceFile before = BesideText.before(file, offset);
        List<CompletionItem> items = new ArrayList<>();
        List<Choice> choices = text.choices(offset);
        choices.forEach(each -> items.add(item(each)));
        if (BesideText.lastLine(before).isEmpty()) {
            boolean isAlone = (before.text() + file.text().substring(offset)).isBlank();
            LineSkeleton.fitting(file.path(), isAlone, choices).forEach(items::add);
        }
        Range typed = Positions.range(file.span(before.text().length(), offset));
        items.forEach(item -> place(item, typed));
        return items;
    }

    private static CompletionItem item(Choice choice) {
        CompletionItem item = new CompletionItem(choice.word());
        boolean isWord = choice.what().isEmpty();
        item.setKind(isWord ? CompletionItemKind.Keyword : CompletionItemKind.Reference);
        if (!isWord) {
            item.setDetail(choice.what());
        }
        return item;
    }

    /** In the place of the word that is being typed: names have dots, dashes and dollars. */
    private static void place(CompletionItem item, Range typed) {
        String text = item.getInsertText() == null ? item.getLabel() : item.getInsertText();
        item.setTextEdit(Either.forLeft(new TextEdit(typed, text)));
        item.setInsertText(null);
    }
}
