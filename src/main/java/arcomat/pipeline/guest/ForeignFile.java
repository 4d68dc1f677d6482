package arcomat.pipeline.guest;

import arcomat.check.guest.GuestThread;
import arcomat.guest.Meaning;
import arcomat.guest.Meaning.Problem;
import arcomat.guest.host.Guests.Reader;
import arcomat.source.Diagnostic;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.syntax.Parser.Translated;
import arcomat.translate.TranslatedText;
import arcomat.tree.Automaton;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Unit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;

/**
 * A file in the language of a guest, who says which component it stands for. What is wrong with it
 * is told as an error in its syntax.
 *
 * @param reader knows files with such an ending
 */
record ForeignFile(SourceFile file, Reader reader) {
    /** ARC1203: a text is not as its language wants it. */
    private static final String WRONG = "ARC1203";

    /** ARC1205: a guest fails at a file. */
    private static final String FAILED = "ARC1205";

    private static final Duration LIMIT = Duration.ofSeconds(10);

    Parsed parse() {
        Meaning meaning = new Meaning();
        try {
            new GuestThread(reader.guest(), LIMIT)
                    .call(
                            () -> {
                                reader.kind().translate(file, meaning);
                                return meaning;
                            });
        } catch (ExecutionException e) {
            return failed(file.span(0, 0), String.valueOf(e.getCause()));
        } catch (TimeoutException e) {
            return failed(file.span(0, 0), "not done after " + LIMIT.toSeconds() + " s");
        }
        if (!meaning.problems().isEmpty()) {
            return problems(meaning.problems());
        }
        return meaning.pieces().isEmpty()
                ? failed(file.span(0, 0), "it has not said what the file stands for")
                : written(TranslatedText.of(file.path() + ".arc", meaning.pieces()));
    }

    private Parsed problems(List<Problem> problems) {
        List<Diagnostic> findings = new ArrayList<>();
        for (Problem each : problems) {
            String code = each.code().orElse(WRONG);
            if (!code.equals(WRONG) && !reader.codes().contains(code)) {
                return failed(each.place(), "it has not said that it has a code '" + code + "'");
            }
            findings.add(
                    new Diagnostic(
                            code,
                            Severity.ERROR,
                            each.place(),
                            each.message() + " (guest '" + reader.guest() + "')",
                            each.related(),
                            each.fix()));
        }
        findings.sort(Diagnostic.ORDER);
        return new Parsed(Optional.empty(), Optional.empty(), findings);
    }

    private Parsed written(TranslatedText text) {
        Optional<Translated> translated = Parser.parse(text.file(), text::origin);
        if (translated.isEmpty()) {
            Diagnostic first = Parser.parse(text.file()).findings().get(0);
            String line = first.span().file().excerpt(first.span().startPosition().line());
            return failed(
                    text.origin(first.span()),
                    "what it made of the file cannot be read: %s in '%s'"
                            .formatted(first.message(), line));
        }
        Unit written = translated.get().written();
        Unit placed = translated.get().placed();
        if (!(placed.definition() instanceof Component component)) {
            return failed(file.span(0, 0), "what it made of the file is no component");
        }
        // Comments of the translation are nobody's: they suppress and document nothing.
        Unit unit =
                new Unit(
                        file.span(0, file.text().length()),
                        placed.packageName(),
                        placed.imports(),
                        inside(component, (Component) written.definition(), text),
                        List.of(),
                        List.of());
        return new Parsed(Optional.of(unit), Optional.empty(), List.of());
    }

    /** With what a text has no words for: guests say it beside. */
    private static Component inside(Component placed, Component written, TranslatedText text) {
        List<Element> elements = new ArrayList<>();
        for (int i = 0; i < placed.elements().size(); i++) {
            Element each = placed.elements().get(i);
            Element before = written.elements().get(i);
            if (each instanceof Component inner) {
                elements.add(inside(inner, (Component) before, text));
            } else if (each instanceof Automaton automaton) {
                elements.add(text.ordered((Automaton) before, automaton));
            } else {
                elements.add(each);
            }
        }
        return placed.withElements(elements);
    }

    private Parsed failed(Span place, String reason) {
        String message =
                "guest '%s' failed at this file: %s; tell who wrote it"
                        .formatted(reader.guest(), reason);
        return new Parsed(
                Optional.empty(),
                Optional.empty(),
                List.of(Diagnostic.error(FAILED, place, message)));
    }
}
