package arcomat.editor.answer.fact;

import arcomat.editor.desk.View;
import arcomat.editor.foreign.GuestText;
import arcomat.editor.name.Mentions;
import arcomat.editor.text.Positions;
import arcomat.source.Span;
import arcomat.symbols.occurrences.Occurrence;

import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.MarkupContent;
import org.eclipse.lsp4j.MarkupKind;
import org.eclipse.lsp4j.Position;

import java.util.Optional;

/**
 * What is shown beside a name: how it is declared, the comment in front of that, and what else is
 * known of it; beside a word of a guest's language, what that says.
 */
public final class HoverCard {
    private HoverCard() {}

    public static Optional<Hover> at(View view, Position position) {
        int offset = view.offset(position);
        return Mentions.at(view, offset)
                .map(each -> of(view, each))
                .or(() -> guestWord(view, offset));
    }

    /** What a guest says about a word of its language. */
    private static Optional<Hover> guestWord(View view, int offset) {
        for (GuestText text : GuestText.in(view)) {
            for (Span word : text.words()) {
                String said = text.language().words().get(word.text());
                if (said != null && word.start() <= offset && offset <= word.end()) {
                    String shown = Markdown.code(word.text()) + "\n\n" + Markdown.text(said);
                    return Optional.of(
                            new Hover(
                                    new MarkupContent(MarkupKind.MARKDOWN, shown),
                                    Positions.range(word)));
                }
            }
        }
        return Optional.empty();
    }

    private static Hover of(View view, Occurrence occurrence) {
        return new Hover(
                new MarkupContent(MarkupKind.MARKDOWN, NameFacts.of(view.models(), occurrence)),
                Positions.range(occurrence.span()));
    }
}
