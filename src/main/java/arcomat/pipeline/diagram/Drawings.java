package arcomat.pipeline.diagram;

import arcomat.diagram.AutomatonGraph;
import arcomat.diagram.ComponentGraph;
import arcomat.diagram.Graph;
import arcomat.diagram.Highlights;
import arcomat.diagram.TypesGraph;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.diagram.MarkedFindings.Marked;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * What there is to draw, by file name: a component with parts under its name, as a component with
 * one automaton; where there are several, the automaton's name or number follows.
 */
final class Drawings {
    private final int depth;
    private final List<Marked> marked;
    private final Map<String, Graph> graphs = new LinkedHashMap<>();
    private final Set<String> taken = new TreeSet<>();

    /**
     * @param marked findings that are marked in the pictures
     */
    private Drawings(int depth, List<Marked> marked) {
        this.depth = depth;
        this.marked = marked;
    }

    /**
     * @param components qualified names; empty for all components and class diagrams that were
     *     named by their files
     * @throws WrongUse where there is no such component or class diagram
     */
    static Drawings of(
            List<String> components, int depth, List<Marked> marked, LoweredModels models)
            throws WrongUse {
        Drawings drawings = new Drawings(depth, marked);
        for (String name : components) {
            drawings.addNamed(name, models);
        }
        if (components.isEmpty()) {
            drawings.addAll(models);
        }
        return drawings;
    }

    private void addNamed(String name, LoweredModels models) throws WrongUse {
        List<DiagramSymbol> types =
                models.checked().workspace().diagrams().stream()
                        .filter(each -> each.qualifiedName().equals(name))
                        .toList();
        if (types.isEmpty() || models.model().component(name).isPresent()) {
            add(MainComponent.component(name, models));
        }
        types.forEach(this::add);
    }

    private void addAll(LoweredModels models) {
        models.named().forEach(this::add);
        models.checked().workspace().diagrams().stream()
                .filter(each -> isNamed(each, models))
                .forEach(this::add);
    }

    private static boolean isNamed(DiagramSymbol types, LoweredModels models) {
        return models.checked().loaded().isNamedByUser(types.unit().file().path());
    }

    Map<String, Graph> graphs() {
        return graphs;
    }

    void add(Component component) {
        String name = component.qualifiedName();
        boolean drawn = component.isComposite() || component.automata().isEmpty();
        if (drawn) {
            add(name, ComponentGraph.of(component, depth));
        }
        List<Automaton> automata = component.automata();
        for (int i = 0; i < automata.size(); i++) {
            String own = automata.get(i).name().isEmpty() ? "" + (i + 1) : automata.get(i).name();
            boolean sole = automata.size() == 1 && !drawn;
            Automaton automaton = automata.get(i);
            Highlights highlights = FindingHighlights.of(automaton, marked);
            add(
                    sole ? name : name + "-" + own,
                    AutomatonGraph.of(component, automaton, highlights));
        }
    }

    void add(DiagramSymbol diagram) {
        List<TypesGraph.TypeBox> boxes = new ArrayList<>();
        diagram.types().forEach(type -> boxes.add(box(type, diagram)));
        add(
                diagram.qualifiedName(),
                TypesGraph.of(diagram.qualifiedName(), boxes, diagram.node().name().span()));
    }

    private static TypesGraph.TypeBox box(DefinedType type, DiagramSymbol diagram) {
        ClassDiagram.TypeDefinition node = type.node();
        String name = node.name().text();
        if (node instanceof ClassDiagram.EnumDefinition enumeration) {
            List<String> constants =
                    enumeration.constants().stream().map(constant -> constant.text()).toList();
            return new TypesGraph.TypeBox(
                    name, true, constants, Optional.empty(), node.name().span());
        }
        if (!(node instanceof ClassDiagram.ClassDefinition definition)) {
            return new TypesGraph.TypeBox(
                    name, false, List.of(), Optional.empty(), node.name().span());
        }
        List<String> attributes =
                definition.attributes().stream()
                        .map(each -> each.name().text() + ": " + each.type().span().text())
                        .toList();
        Optional<String> above =
                definition
                        .superClass()
                        .map(reference -> reference.span().text())
                        .filter(wanted -> isIn(diagram, wanted));
        return new TypesGraph.TypeBox(name, false, attributes, above, node.name().span());
    }

    private static boolean isIn(DiagramSymbol diagram, String name) {
        return diagram.types().stream().anyMatch(each -> each.node().name().text().equals(name));
    }

    /** Names are told apart also where files are not told apart by case. */
    private void add(String name, Graph graph) {
        String safe = name.replaceAll("[^\\p{L}\\p{N}._$-]+", "_");
        String free = safe;
        for (int i = 2; !taken.add(free.toLowerCase(Locale.ROOT)); i++) {
            free = safe + "-" + i;
        }
        graphs.put(free, graph);
    }
}
