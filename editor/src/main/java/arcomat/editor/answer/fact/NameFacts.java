package arcomat.editor.answer.fact;

import arcomat.pipeline.recheck.ReadModels;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Referent;

import java.util.List;
import java.util.stream.Collectors;

/** What is known of a name, whoever shows it: an editor or a page. */
public final class NameFacts {
    private NameFacts() {}

    /** In Markdown: a line of the language, the comment in front of it, and a list. */
    public static String of(ReadModels models, Occurrence occurrence) {
        Referent referent = occurrence.referent();
        StringBuilder text = new StringBuilder();
        text.append(Markdown.code(referent.match(new DeclarationLine())));
        DocComment.of(referent, models)
                .ifPresent(comment -> text.append("\n\n").append(Markdown.text(comment)));
        List<String> facts = referent.match(new KnownFacts(models, occurrence.span()));
        if (!facts.isEmpty()) {
            text.append(
                    facts.stream()
                            .map(fact -> "\n* " + fact)
                            .collect(Collectors.joining("", "\n", "")));
        }
        return text.toString();
    }
}
