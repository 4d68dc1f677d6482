package arcomat.pipeline.guest;

import arcomat.check.guest.GuestThread;
import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.Meaning;
import arcomat.guest.Meaning.Piece;
import arcomat.guest.Meaning.Problem;
import arcomat.guest.host.Guests;
import arcomat.guest.host.Guests.Language;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeoutException;

/**
 * Reads a file, and has guests say what the behaviours in their languages mean. What is wrong with
 * one is told as an error in its syntax: the rest of the file can be looked at, and nobody works
 * with the gap.
 */
public final class ForeignBehaviours {
    /** ARC1203: a behaviour is not as its language wants it. */
    private static final String WRONG = "ARC1203";

    /** ARC1204: a guest fails while it translates. */
    private static final String FAILED = "ARC1204";

    /** A behaviour is a page of text at most. */
    private static final Duration LIMIT = Duration.ofSeconds(10);

    private final Guests guests;
    private final List<Diagnostic> findings = new ArrayList<>();
    private final List<Span> gaps = new ArrayList<>();

    private ForeignBehaviours(Guests guests) {
        this.guests = guests;
    }

    /** What came of reading the file, with the automata of behaviours that guests know. */
    public static Parsed parse(SourceFile file, Guests guests) {
        Parsed parsed = Parser.parse(file);
        return guests.languages().isEmpty() ? parsed : new ForeignBehaviours(guests).in(parsed);
    }

    private Parsed in(Parsed parsed) {
        Optional<Unit> unit = parsed.unit().map(this::in);
        Optional<Recovered> recovered =
                parsed.recovered().map(each -> new Recovered(in(each.unit()), each.gaps()));
        if (findings.isEmpty()) {
            return new Parsed(unit, recovered, parsed.findings());
        }
        List<Diagnostic> all = new ArrayList<>(parsed.findings());
        all.addAll(findings);
        all.sort(Diagnostic.ORDER);
        recovered.ifPresent(each -> gaps.addAll(each.gaps()));
        Optional<Recovered> rest =
                unit.or(() -> recovered.map(Recovered::unit))
                        .map(readable -> new Recovered(readable, gaps));
        return new Parsed(Optional.empty(), rest, all);
    }

    private Unit in(Unit unit) {
        return unit.definition() instanceof Component component
                ? new Unit(
                        unit.span(),
                        unit.packageName(),
                        unit.imports(),
                        in(component),
                        unit.comments())
                : unit;
    }

    private Component in(Component component) {
        List<Element> elements = new ArrayList<>();
        for (Element element : component.elements()) {
            if (element instanceof Behaviour.Foreign foreign) {
                meaning(foreign).ifPresent(elements::add);
            } else {
                elements.add(element instanceof Component inner ? in(inner) : element);
            }
        }
        return component.elements().equals(elements)
                ? component
                : new Component(
                        component.span(),
                        component.stereotypes(),
                        component.isAbstract(),
                        component.isDeploy(),
                        component.name(),
                        component.typeParameters(),
                        component.parameters(),
                        component.superComponent(),
                        component.superArguments(),
                        component.refines(),
                        component.instance(),
                        elements);
    }

    /** Nothing where it is wrong; the behaviour as it was where nobody knows its language. */
    private Optional<Element> meaning(Behaviour.Foreign foreign) {
        Optional<Language> language = guests.language(foreign.keyword().text());
        if (language.isEmpty()) {
            return Optional.of(foreign);
        }
        Meaning meaning = new Meaning();
        try {
            Written written = new Written(foreign.keyword().span(), foreign.name(), foreign.body());
            new GuestThread(language.get().guest(), LIMIT)
                    .call(
                            Executors.callable(
                                    () -> language.get().translator().translate(written, meaning)));
        } catch (ExecutionException e) {
            return failed(foreign, language.get(), String.valueOf(e.getCause()));
        } catch (TimeoutException e) {
            return failed(foreign, language.get(), "not done after " + LIMIT.toSeconds() + " s");
        }
        Optional<String> unknown =
                meaning.problems().stream()
                        .flatMap(each -> each.code().stream())
                        .filter(code -> !language.get().codes().contains(code))
                        .findFirst();
        if (unknown.isPresent()) {
            String reason = "it has not said that it has a code '" + unknown.get() + "'";
            return failed(foreign, language.get(), reason);
        }
        for (Problem problem : meaning.problems()) {
            String message = problem.message() + " (guest '" + language.get().guest() + "')";
            gap(foreign, Diagnostic.error(problem.code().orElse(WRONG), problem.place(), message));
        }
        return meaning.problems().isEmpty()
                ? automaton(foreign, meaning, language.get())
                : Optional.empty();
    }

    private Optional<Element> automaton(
            Behaviour.Foreign foreign, Meaning meaning, Language language) {
        List<Piece> pieces = new ArrayList<>();
        pieces.add(own(foreign.keyword().span(), "automaton {"));
        pieces.addAll(meaning.pieces());
        pieces.add(own(foreign.span(), "}"));
        String path = foreign.span().file().path() + ".ioautomaton";
        TranslatedText text = TranslatedText.of(path, pieces);
        Parsed parsed = Parser.parse(text.file());
        if (parsed.unit().isEmpty()) {
            Diagnostic first = parsed.findings().get(0);
            String message =
                    "guest '%s' made of this behaviour what cannot be read: %s in '%s'; tell who wrote it"
                            .formatted(language.guest(), first.message(), line(first.span()));
            return gap(foreign, Diagnostic.error(FAILED, text.origin(first.span()), message));
        }
        Automaton written = (Automaton) parsed.unit().get().definition();
        List<AutomatonElement> ranked =
                written.elements().stream().map(each -> ranked(each, text)).toList();
        PlacedTree placed = new PlacedTree(text::origin);
        return Optional.of(
                foreign.meaning(
                        new Automaton(
                                foreign.span(),
                                foreign.stereotypes(),
                                foreign.name(),
                                ranked.stream().map(placed::move).toList())));
    }

    /** A text has no word for ranks: guests say them beside it. */
    private static AutomatonElement ranked(AutomatonElement element, TranslatedText text) {
        return element instanceof AutomatonElement.Transition transition
                ? transition.withRank(text.rank(transition.span()))
                : element;
    }

    private static Piece own(Span place, String text) {
        return new Piece(place, text, Optional.empty(), 0);
    }

    private static String line(Span place) {
        return place.file().line(place.startPosition().line()).strip();
    }

    private Optional<Element> failed(Behaviour.Foreign foreign, Language language, String reason) {
        String message =
                "guest '%s' failed at this behaviour: %s; tell who wrote it"
                        .formatted(language.guest(), reason);
        return gap(foreign, Diagnostic.error(FAILED, foreign.keyword().span(), message));
    }

    private Optional<Element> gap(Behaviour.Foreign foreign, Diagnostic finding) {
        findings.add(finding);
        gaps.add(foreign.span());
        return Optional.empty();
    }
}
