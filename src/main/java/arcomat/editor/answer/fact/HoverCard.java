package arcomat.editor.answer.fact;

import arcomat.editor.desk.View;
import arcomat.editor.name.Mentions;
import arcomat.editor.text.Positions;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Referent;

import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.MarkupContent;
import org.eclipse.lsp4j.MarkupKind;
import org.eclipse.lsp4j.Position;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What is shown beside a name: how it is declared, the comment in front of that, and what else is
 * known of it.
 */
public final class HoverCard {
    private HoverCard() {}

    public static Optional<Hover> at(View view, Position position) {
        return Mentions.at(view, view.offset(position)).map(each -> of(view, each));
    }

    private static Hover of(View view, Occurrence occurrence) {
        Referent referent = occurrence.referent();
        StringBuilder text = new StringBuilder();
        text.append(Markdown.code(referent.match(new DeclarationLine())));
        DocComment.of(referent, view.models())
                .ifPresent(comment -> text.append("\n\n").append(Markdown.text(comment)));
        List<String> facts = referent.match(new KnownFacts(view.models(), occurrence.span()));
        if (!facts.isEmpty()) {
            text.append(
                    facts.stream()
                            .map(fact -> "\n* " + fact)
                            .collect(Collectors.joining("", "\n", "")));
        }
        return new Hover(
                new MarkupContent(MarkupKind.MARKDOWN, text.toString()),
                Positions.range(occurrence.span()));
    }
}
