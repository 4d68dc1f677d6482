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
     * What came of it.
     *
     * @param gaps parts of the text without which the rest can be read; none where that is not so
     *     of all that is wrong
     */
    record Answer(Reading reading, List<Span> gaps) {
        /** What is wrong with the whole. */
        static Answer of(Reading reading) {
            return new Answer(reading, List.of());
        }
    }

    /**
     * What it means, or what is wrong.
     *
     * @param mayWait whether a guest may have nothing to say yet; the answer is empty then
     */
    Answer ask(Question question, boolean mayWait) {
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
            return beside(meaning.problems(), problems);
        }
        return mayWait && meaning.pieces().isEmpty()
                ? Answer.of(Reading.of(problems))
                : automaton(LanguageTranslation.of(behaviour, meaning), problems);
    }

    private Answer beside(List<Meaning.Problem> said, List<Problem> told) {
        List<Span> gaps = said.stream().flatMap(each -> each.gap().stream()).toList();
        if (!gaps.stream().allMatch(behaviour.body()::isAround)) {
            return failed("it leaves out what does not stand in the text");
        }
        return new Answer(Reading.of(told), gaps.size() == said.size() ? gaps : List.of());
    }

    private String named() {
        return " (guest '" + language.guest() + "')";
    }

    private Problem told(Meaning.Problem problem) {
        return new Problem(
                problem.code().orElse(WRONG),
                problem.place(),
                problem.message() + named(),
                problem.related(),
                problem.fix());
    }

    private Answer automaton(LanguageTranslation translation, List<Problem> problems) {
        return translation
                .reading(Parser::parse, problems)
                .map(Answer::of)
                .orElseGet(() -> unreadable(translation.text()));
    }

    /** What was taken over letter by letter was written by whoever wrote the behaviour. */
    private Answer unreadable(TranslatedText text) {
        List<Diagnostic> findings = Parser.parse(text.file()).findings();
        List<TakenOver> written =
                findings.stream().flatMap(each -> TakenOver.of(each, text).stream()).toList();
        if (written.size() < findings.size()) {
            return madeUnreadable(text, findings.get(0));
        }
        return new Answer(
                Reading.of(written.stream().map(this::told).toList()),
                written.stream().map(TakenOver::part).filter(behaviour.body()::isAround).toList());
    }

    private Problem told(TakenOver each) {
        return new Problem(WRONG, each.place(), each.message() + named());
    }

    private Answer madeUnreadable(TranslatedText text, Diagnostic first) {
        String message =
                "guest '%s' made of this behaviour what cannot be read: %s in '%s'; tell who wrote it"
                        .formatted(language.guest(), first.message(), line(first.span()));
        return wrong(text.origin(first.span()), message);
    }

    private static String line(Span place) {
        return place.file().line(place.startPosition().line()).strip();
    }

    private Answer failed(String reason) {
        String message =
                "guest '%s' failed at this behaviour: %s; tell who wrote it"
                        .formatted(language.guest(), reason);
        return wrong(behaviour.keyword().span(), message);
    }

    private static Answer wrong(Span place, String message) {
        return Answer.of(Reading.of(List.of(new Problem(FAILED, place, message))));
    }
}
