package arcomat.pipeline.gate;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * One side of the gate: its components by their names as written. What a generic component is with
 * different type arguments stands below one name.
 */
record GateSide(CheckedModels checked, Model model, SortedMap<String, Declared> components) {

    /**
     * A component as it is written.
     *
     * @param span all of it
     * @param name the place of its name
     * @param stereotypes on it and on its automata
     * @param instantiations by qualified name; just one, of its own name, if it is not generic,
     *     none if it is and nobody gives it arguments
     */
    record Declared(
            Span span,
            Span name,
            List<Stereotype> stereotypes,
            SortedMap<String, Component> instantiations) {}

    static GateSide of(LoweredModels models) {
        GateSide side = new GateSide(models.checked(), models.model(), new TreeMap<>());
        for (ComponentSymbol symbol : side.checked.workspace().components()) {
            List<Stereotype> stereotypes = new ArrayList<>(symbol.stereotypes());
            symbol.ownAutomata().forEach(each -> stereotypes.addAll(each.node().stereotypes()));
            side.declare(
                    symbol.qualifiedName(), symbol.node().span(), symbol.nameSpan(), stereotypes);
        }
        for (Component component : side.model.components()) {
            side.components
                    .computeIfAbsent(written(component), name -> side.bare(component))
                    .instantiations()
                    .put(component.qualifiedName(), component);
        }
        return side;
    }

    private void declare(String name, Span span, Span place, List<Stereotype> stereotypes) {
        components.put(name, new Declared(span, place, stereotypes, new TreeMap<>()));
    }

    /** An automaton in a file of its own is a component, too. */
    private Declared bare(Component component) {
        AutomatonSymbol symbol =
                checked.workspace().bareAutomata().stream()
                        .filter(each -> each.node().span().equals(component.span()))
                        .findFirst()
                        .orElseThrow();
        Span name = symbol.node().name().map(Name::span).orElse(component.span());
        return new Declared(component.span(), name, symbol.node().stereotypes(), new TreeMap<>());
    }

    /** Without type arguments. */
    private static String written(Component component) {
        String name = component.qualifiedName();
        int arguments = name.indexOf('<');
        return arguments < 0 ? name : name.substring(0, arguments);
    }

    /** Whether no file is left out. */
    boolean isWhole() {
        return checked.aside().isEmpty();
    }

    /** Whether a component may stand in a file that is left out, or a reason why it is gone. */
    boolean mayTellOf(String name) {
        return checked.aside().words().contains(name.substring(name.lastIndexOf('.') + 1))
                || mayGiveReasons();
    }

    /** Whether a file that is left out may say why something is gone. */
    boolean mayGiveReasons() {
        return checked.aside().words().contains(BreakReasons.REPLACES);
    }

    boolean isNamedByUser(Declared component) {
        return checked.loaded().isNamedByUser(component.span().file().path());
    }
}
