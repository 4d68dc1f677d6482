package arcomat.editor.answer.shape;

import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Component;

import org.eclipse.lsp4j.SymbolKind;

import java.util.List;
import java.util.stream.Stream;

/** The outline of a component: what it declares itself, and what is declared in that. */
final class ComponentOutline {
    private ComponentOutline() {}

    static OutlineEntry of(ComponentSymbol component) {
        return OutlineEntry.of(
                new Referent.Component(component.signature()),
                component.node().span(),
                Stream.of(
                                members(component.signature()),
                                parts(component),
                                component.innerComponents().stream().map(ComponentOutline::of),
                                component.ownInvariants().stream()
                                        .map(
                                                each ->
                                                        OutlineEntry.of(
                                                                new Referent.Invariant(each),
                                                                each.node().span(),
                                                                Stream.empty())),
                                component.ownAutomata().stream().map(ComponentOutline::automaton),
                                component.ownTables().stream().map(ComponentOutline::table))
                        .flatMap(each -> each));
    }

    private static Stream<OutlineEntry> members(Signature signature) {
        Stream<Referent> parameters =
                signature.ownParameters().stream().map(Referent.Parameter::new);
        Stream<Referent> ports = signature.ownPorts().stream().map(Referent.Port::new);
        Stream<Referent> variables = signature.ownVariables().stream().map(Referent.Variable::new);
        return lines(Stream.of(parameters, ports, variables).flatMap(each -> each));
    }

    /** Whatever has its component written at the same place is that component's line. */
    private static Stream<OutlineEntry> parts(ComponentSymbol component) {
        return lines(
                component.ownInstances().stream()
                        .filter(each -> !(each.node() instanceof Component))
                        .map(Referent.Part::new));
    }

    /** An array has one line. */
    private static Stream<OutlineEntry> lines(Stream<? extends Referent> declared) {
        return declared.map(Referent.Array::whole).distinct().map(OutlineEntry::of);
    }

    static OutlineEntry automaton(AutomatonSymbol automaton) {
        Stream<Referent> ports = automaton.declaredPorts().stream().map(Referent.Port::new);
        Stream<Referent> variables = automaton.variables().stream().map(Referent.Variable::new);
        Stream<Referent> states =
                automaton.states().stream().map(each -> new Referent.State(automaton, each));
        Stream<OutlineEntry> inside =
                lines(Stream.of(ports, variables, states).flatMap(each -> each));
        Span whole = automaton.node().span();
        return automaton
                .node()
                .name()
                .map(name -> OutlineEntry.of(new Referent.Behaviour(name), whole, inside))
                .orElseGet(() -> unnamed("automaton", whole, inside));
    }

    private static OutlineEntry table(TableSymbol table) {
        return unnamed("table", table.node().span(), Stream.empty());
    }

    private static OutlineEntry unnamed(String name, Span whole, Stream<OutlineEntry> inside) {
        List<OutlineEntry> lines = OutlineEntry.inTextOrder(inside);
        return new OutlineEntry(name, SymbolKind.Enum, whole, whole.firstLine(), "", lines);
    }
}
