package arcomat.pipeline.guest;

import arcomat.check.guest.GuestThread;
import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.Meaning;
import arcomat.guest.host.Guests.Language;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.symbols.signatures.BehaviourReader.Problem;
import arcomat.symbols.signatures.BehaviourReader.Reading;
import arcomat.syntax.Parser;
import arcomat.translate.LanguageTranslation;
import arcomat.translate.TranslatedText;
import arcomat.tree.Behaviour;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeoutException;

/**
 * A behaviour that its guest is asked about.
 *
 * @param language that it is written in
 */
record BehaviourTranslation(Behaviour.Foreign behaviour, Language language) {
    /** ARC1203: a behaviour is not as its language wants it. */
    private static final String WRONG = "ARC1203";

    /** ARC1204: a guest fails while it translates. */
    private static final String FAILED = "ARC1204";

    /** A behaviour is a page of text at most. */
    private static final Duration LIMIT = Duration.ofSeconds(10);

    /** How a guest is asked. */
    interface Question {
        void put(Written written, Meaning meaning);
    }

    /**
     * What it means, or what is wrong.
     *
     * @param mayWait whether a guest may have nothing to say yet; the answer is empty then
     */
    Reading ask(Question question, boolean mayWait) {
        Meaning meaning = new Meaning();
        Written written = LanguageTranslation.written(behaviour);
        try {
            new GuestThread(language.guest(), LIMIT)
                    .call(Executors.callable(() -> question.put(written, meaning)));
        } catch (ExecutionException e) {
            return failed(String.valueOf(e.getCause()));
        } catch (TimeoutException e) {
            return failed("not done after " + LIMIT.toSeconds() + " s");
        }
        Optional<String> unknown =
                meaning.problems().stream()
                        .flatMap(each -> each.code().stream())
                        .filter(code -> !language.codes().contains(code))
                        .findFirst();
        if (unknown.isPresent()) {
            return failed("it has not said that it has a code '" + unknown.get() + "'");
        }
        List<Problem> problems = meaning.problems().stream().map(this::told).toList();
        if (!problems.isEmpty() && !meaning.isStanding()) {
            return Reading.of(problems);
        }
        return mayWait && meaning.pieces().isEmpty()
                ? Reading.of(problems)
                : automaton(LanguageTranslation.of(behaviour, meaning), problems);
    }

    private Problem told(Meaning.Problem problem) {
        return new Problem(
                problem.code().orElse(WRONG),
                problem.place(),
                problem.message() + " (guest '" + language.guest() + "')",
                problem.related(),
                problem.fix());
    }

    private Reading automaton(LanguageTranslation translation, List<Problem> problems) {
        return translation
                .reading(Parser::parse, problems)
                .orElseGet(() -> unreadable(translation.text()));
    }

    private Reading unreadable(TranslatedText text) {
        Diagnostic first = Parser.parse(text.file()).findings().get(0);
        String message =
                "guest '%s' made of this behaviour what cannot be read: %s in '%s'; tell who wrote it"
                        .formatted(language.guest(), first.message(), line(first.span()));
        return wrong(text.origin(first.span()), message);
    }

    private static String line(Span place) {
        return place.file().line(place.startPosition().line()).strip();
    }

    private Reading failed(String reason) {
        String message =
                "guest '%s' failed at this behaviour: %s; tell who wrote it"
                        .formatted(language.guest(), reason);
        return wrong(behaviour.keyword().span(), message);
    }

    private static Reading wrong(Span place, String message) {
        return Reading.of(List.of(new Problem(FAILED, place, message)));
    }
}
