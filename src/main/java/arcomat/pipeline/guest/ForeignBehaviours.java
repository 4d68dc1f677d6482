package arcomat.pipeline.guest;

import arcomat.guest.BehaviourLanguage;
import arcomat.guest.SituatedLanguage;
import arcomat.guest.host.Guests;
import arcomat.guest.host.Guests.Language;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.symbols.signatures.BehaviourReader.Reading;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reads a file, and has guests say what the behaviours in their languages mean. What is wrong with
 * one is told as an error in its syntax: the rest of the file can be looked at, and nobody works
 * with the gap.
 */
public final class ForeignBehaviours {
    private final Guests guests;
    private final List<Diagnostic> findings = new ArrayList<>();
    private final List<Span> gaps = new ArrayList<>();

    private ForeignBehaviours(Guests guests) {
        this.guests = guests;
    }

    /** What came of reading the file, with the automata of behaviours that guests know. */
    public static Parsed parse(SourceFile file, Guests guests) {
        Optional<Guests.Reader> reader = guests.reader(file.path());
        if (reader.isPresent()) {
            return new ForeignFile(file, reader.get()).parse();
        }
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
                        unit.comments(),
                        unit.spellings())
                : unit;
    }

    private Component in(Component component) {
        List<Element> elements = in(component.elements());
        return component.elements().equals(elements) ? component : component.withElements(elements);
    }

    private List<Element> in(List<Element> written) {
        List<Element> elements = new ArrayList<>();
        for (Element element : written) {
            if (element instanceof Behaviour.Foreign foreign) {
                meaning(foreign).ifPresent(elements::add);
            } else {
                elements.add(inside(element));
            }
        }
        return elements;
    }

    private Element inside(Element element) {
        if (element instanceof Element.Variation variation) {
            return in(variation);
        }
        return element instanceof Component inner ? in(inner) : element;
    }

    private Element.Variation in(Element.Variation variation) {
        return new Element.Variation(
                variation.span(),
                variation.condition(),
                in(variation.then()),
                in(variation.otherwise()));
    }

    /** Nothing where it is wrong; the behaviour as it was where nobody can read it yet. */
    private Optional<Element> meaning(Behaviour.Foreign foreign) {
        Optional<Language> language = guests.language(foreign.keyword().text());
        if (language.isEmpty()) {
            return Optional.of(foreign);
        }
        BehaviourTranslation.Answer answer = ask(foreign, language.get());
        answer.reading().problems().forEach(each -> findings.add(each.error()));
        if (answer.reading().problems().isEmpty()) {
            return Optional.of(meaning(foreign, answer.reading()));
        }
        Optional<Element> rest = rest(foreign, language.get(), answer.gaps());
        gaps.addAll(rest.isPresent() ? answer.gaps() : List.of(foreign.span()));
        return rest;
    }

    private static BehaviourTranslation.Answer ask(Behaviour.Foreign foreign, Language language) {
        BehaviourLanguage translator = language.translator();
        return new BehaviourTranslation(foreign, language)
                .ask(translator::translate, translator instanceof SituatedLanguage);
    }

    private static Element meaning(Behaviour.Foreign foreign, Reading reading) {
        return reading.automaton().map(foreign::meaning).orElse(foreign);
    }

    /** What can be read of a behaviour without some parts; nothing where those are not known. */
    private static Optional<Element> rest(
            Behaviour.Foreign foreign, Language language, List<Span> without) {
        if (without.isEmpty()) {
            return Optional.empty();
        }
        Behaviour.Foreign rest = foreign.without(without);
        Reading reading = ask(rest, language).reading();
        return reading.problems().isEmpty()
                ? Optional.of(meaning(rest, reading))
                : Optional.empty();
    }
}
