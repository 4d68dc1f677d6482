package arcomat.symbols.occurrences;

import arcomat.symbols.Workspace;
import arcomat.symbols.names.UnitScope;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** All places of a file where names stand that are known. */
public final class Occurrences {
    private Occurrences() {}

    /**
     * @param unit of the workspace, also one that was recovered from a file with errors
     * @return in text order; no two in one place. Names that nothing has, or several things, are
     *     not among them, and neither is what is no name: labels, languages of guards, Java
     */
    public static List<Occurrence> of(Workspace workspace, Unit unit) {
        NamePlaces places = new NamePlaces();
        unit.packageName()
                .ifPresent(
                        name ->
                                Referent.ofPackage(name.text())
                                        .ifPresent(last -> places.path(name.parts(), last)));
        for (Unit.Import each : unit.imports()) {
            imported(workspace, workspace.scope(unit), each)
                    .ifPresent(target -> places.path(each.name().parts(), target));
        }
        definition(workspace, unit, places);
        return places.inTextOrder();
    }

    private static void definition(Workspace workspace, Unit unit, NamePlaces places) {
        UnitScope scope = workspace.scope(unit);
        ExpressionPlaces outside = new ExpressionPlaces(places, scope::type, Optional.empty());
        workspace.topLevelComponents().stream()
                .filter(each -> each.unit() == unit)
                .forEach(each -> ComponentPlaces.in(each, places));
        workspace.bareAutomata().stream()
                .filter(each -> each.unit() == unit)
                .forEach(new BehaviourPlaces(places, outside)::automaton);
        workspace.diagrams().stream()
                .filter(each -> each.unit() == unit)
                .forEach(new DiagramPlaces(places, scope)::in);
        workspace.testSuites().stream()
                .filter(each -> each.unit() == unit)
                .forEach(new SuitePlaces(places, outside)::in);
    }

    /** Empty where several things have the name, or nothing. */
    private static Optional<Referent> imported(
            Workspace workspace, UnitScope scope, Unit.Import imported) {
        String name = imported.name().text();
        List<Referent> named = new ArrayList<>();
        workspace
                .components(name)
                .forEach(each -> named.add(new Referent.Component(each.signature())));
        workspace.types(name).forEach(each -> named.add(new Referent.Type(each)));
        workspace.diagrams().stream()
                .filter(each -> each.qualifiedName().equals(name))
                .forEach(each -> named.add(Referent.diagramOf(each.unit(), each.node())));
        if (named.isEmpty() && !imported.wildcard()) {
            workspace.typesOfPackage(name).forEach(each -> named.add(new Referent.Type(each)));
        }
        if (named.isEmpty() && scope.target(imported).isFound()) {
            return Referent.ofPackage(name);
        }
        return named.size() == 1 ? Optional.of(named.get(0)) : Optional.empty();
    }
}
