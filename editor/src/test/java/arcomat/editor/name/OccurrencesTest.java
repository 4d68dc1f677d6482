package arcomat.editor.name;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.editor.desk.View;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.symbols.bodies.InstanceSymbol.Origin;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Occurrences;
import arcomat.symbols.occurrences.Referent;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Element;
import arcomat.tree.Expression;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.Token;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Every name of every model of this repository is known for what it is. */
class OccurrencesTest {
    private static final int FEWEST_FILES = 100;

    private static ShippedModels models;

    @BeforeAll
    static void read() {
        models = ShippedModels.checked();
    }

    @Test
    void everyWordOfAFileWithoutErrorsIsTheNameOfOneThingOrExplained() {
        int files = 0;
        List<String> unknown = new ArrayList<>();
        for (View view : models.views()) {
            Optional<Unit> unit = view.parsed().unit();
            if (unit.isPresent() && view.findings().stream().noneMatch(Diagnostic::isError)) {
                files++;
                unknownWords(view, unit.get(), unknown);
            }
        }
        assertThat(unknown).isEmpty();
        assertThat(files).isGreaterThan(FEWEST_FILES);
    }

    private static void unknownWords(View view, Unit unit, List<String> unknown) {
        Set<Integer> known = new HashSet<>();
        of(view, unit).forEach(each -> known.add(each.span().start()));
        List<Span> explained = new ArrayList<>();
        collectExplained(unit, explained);
        view.findings().stream()
                .filter(each -> each.code().equals("ARC0147")) // a type of Java without its import
                .forEach(each -> explained.add(each.span()));
        ArcomatLexer lexer = new ArcomatLexer(CharStreams.fromString(view.file().text()));
        for (Token token : lexer.getAllTokens()) {
            int at = token.getStartIndex();
            boolean isKnown =
                    known.contains(at)
                            || explained.stream()
                                    .anyMatch(span -> span.start() <= at && at < span.end());
            if (token.getType() == ArcomatLexer.ID && !isKnown) {
                unknown.add(view.file().span(at, at) + " " + token.getText());
            }
        }
    }

    /** What is no name of a model, though it looks like one. */
    private static void collectExplained(Object node, List<Span> explained) {
        if (node instanceof Collection<?> many) {
            many.forEach(each -> collectExplained(each, explained));
        } else if (node instanceof Optional<?> perhaps) {
            perhaps.ifPresent(each -> collectExplained(each, explained));
        } else if (node instanceof Node && node.getClass().isRecord()) {
            explained.addAll(explained((Node) node));
            for (RecordComponent part : node.getClass().getRecordComponents()) {
                collectExplained(value(part, node), explained);
            }
        }
    }

    private static Object value(RecordComponent part, Object node) {
        try {
            return part.getAccessor().invoke(node);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }

    private static List<Span> explained(Node node) {
        List<Span> spans = new ArrayList<>();
        if (node instanceof AutomatonElement.Guard guard) {
            guard.kind().ifPresent(kind -> spans.add(kind.span()));
        }
        if (node instanceof Element.Invariant invariant) {
            invariant.kind().ifPresent(kind -> spans.add(kind.span()));
            if (invariant.condition().isEmpty()) {
                spans.add(
                        invariant
                                .span()
                                .file()
                                .span(invariant.name().span().end(), invariant.span().end()));
            }
        }
        if (node instanceof Expression.Domain domain && domain.named().isEmpty()) {
            Span written = domain.span();
            int kind = written.text().indexOf('{');
            spans.add(written.file().span(written.start(), written.start() + kind));
        }
        boolean isNamedNumber =
                node instanceof Expression.Reference reference
                        && Set.of("NaN", "Infinity").contains(reference.name().text());
        if (isNamedNumber
                || node instanceof Stereotype
                || node instanceof TestSuite.Tick
                || node instanceof TestSuite.Before
                || node instanceof Element.JavaPart) {
            spans.add(node.span());
        }
        return spans;
    }

    @Test
    void noTwoThingsAreNamedInOnePlaceAndEachIsNamedAsItIs() {
        for (View view : models.views()) {
            view.parsed().readable().ifPresent(unit -> oneEach(of(view, unit)));
        }
    }

    private static void oneEach(List<Occurrence> occurrences) {
        Map<Integer, Occurrence> byStart = new HashMap<>();
        for (Occurrence each : occurrences) {
            assertThat(byStart.put(each.span().start(), each)).as("%s", each).isNull();
            if (each.referent().kind() != Referent.Kind.BUILTIN) {
                assertThat(each.span().text()).isEqualTo(each.referent().name());
            }
        }
    }

    @Test
    void whatIsNamedDeclaresItselfThere() {
        Map<String, Map<Span, Referent>> declared = new HashMap<>();
        for (View view : models.views()) {
            view.parsed()
                    .readable()
                    .ifPresent(
                            unit ->
                                    of(view, unit).stream()
                                            .filter(each -> !isImplicit(each.referent()))
                                            .forEach(each -> declares(view, each, declared)));
        }
    }

    private static void declares(
            View view, Occurrence each, Map<String, Map<Span, Referent>> declared) {
        Optional<Span> place = each.referent().declaration();
        if (place.isPresent()) {
            Span span = place.get();
            String key = view.models().root() + " " + span.file().path();
            Map<Span, Referent> there =
                    declared.computeIfAbsent(key, any -> declaredIn(view, span.file().path()));
            assertThat(there.get(span)).as("%s", each).isEqualTo(each.referent());
        }
    }

    private static Map<Span, Referent> declaredIn(View view, String path) {
        Unit unit = view.models().parsed(path).flatMap(each -> each.readable()).orElseThrow();
        Map<Span, Referent> declared = new HashMap<>();
        of(view, unit).stream()
                .filter(Occurrence::isDeclaration)
                .forEach(each -> declared.put(each.span(), each.referent()));
        return declared;
    }

    /** Named after its type: nothing but the type stands there. */
    private static boolean isImplicit(Referent referent) {
        return referent instanceof Referent.Port port && port.symbol().implicit()
                || referent instanceof Referent.Part part && part.symbol().origin() != Origin.NAMED;
    }

    private static List<Occurrence> of(View view, Unit unit) {
        return Occurrences.of(view.models().workspace(), unit);
    }
}
