package arcomat.symbols;

import arcomat.source.SourceFile;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.Delays;
import arcomat.symbols.bodies.Parts;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.ComponentDeclaration;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.Index;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Names;
import arcomat.symbols.names.OpaqueSymbol;
import arcomat.symbols.names.Outline;
import arcomat.symbols.names.UnitScope;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Definition;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Everything that a set of files defines. Names across files are resolved on demand; nothing here
 * changes once it can be seen. Several definitions of one name are all kept.
 */
public final class Workspace {
    private final List<Unit> units;
    private final Index index = new Index();
    private final Map<SourceFile, UnitScope> scopes = new IdentityHashMap<>();
    private final Map<ComponentDeclaration, Signature> signatures = new IdentityHashMap<>();
    private final Map<Signature, ComponentSymbol> symbols = new IdentityHashMap<>();
    private final List<ComponentSymbol> topLevel = new ArrayList<>();
    private final List<ComponentSymbol> components = new ArrayList<>();
    private final List<ComponentSymbol> configured = new ArrayList<>();
    private final List<DiagramSymbol> diagrams = new ArrayList<>();
    private final List<AutomatonSymbol> bareAutomata = new ArrayList<>();
    private final List<TestSuiteSymbol> testSuites = new ArrayList<>();
    private final boolean complete;
    private final List<Outline> others;
    private final Lazy<List<Outline>> outlines = new Lazy<>(this::allOutlines);
    private final Delays delays = new Delays();
    private final BehaviourReader reader;

    private Workspace(
            List<Unit> units,
            List<Unit> unseen,
            Set<String> brokenFiles,
            List<Outline> others,
            BehaviourReader reader) {
        this.reader = reader;
        this.complete = brokenFiles.isEmpty();
        this.units = List.copyOf(units);
        this.others = List.copyOf(others);
        brokenFiles.forEach(index::addBroken);
        this.others.forEach(index::addQualifiers);
        this.units.forEach(unit -> add(unit, true));
        unseen.forEach(unit -> add(unit, false));
    }

    /**
     * @param brokenFiles paths of files that did not parse; names that they should define are
     *     excused
     * @param reader of behaviours that are not read yet
     */
    public static Workspace of(List<Unit> units, Set<String> brokenFiles, BehaviourReader reader) {
        return of(units, brokenFiles, List.of(), reader);
    }

    /**
     * A part of a larger set of files. Of the others only the names are known, which is enough
     * where no file of the part refers to them.
     *
     * @param brokenFiles as above, those of the other part included
     * @param reader of behaviours that are not read yet
     */
    public static Workspace of(
            List<Unit> units,
            Set<String> brokenFiles,
            List<Outline> others,
            BehaviourReader reader) {
        return new Workspace(units, List.of(), brokenFiles, others, reader);
    }

    /**
     * With files of which only parts are known. They see the others; nobody sees them, so that
     * nothing is found about others that has its reason here.
     *
     * @param recovered such files, which are among the broken ones
     */
    public static Workspace around(
            List<Unit> recovered,
            List<Unit> units,
            Set<String> brokenFiles,
            List<Outline> others,
            BehaviourReader reader) {
        return new Workspace(units, recovered, brokenFiles, others, reader);
    }

    /** Whether every file has a tree, so that nothing is excused. */
    public boolean isComplete() {
        return complete;
    }

    private void add(Unit unit, boolean seen) {
        UnitScope scope = new UnitScope(unit, index);
        scopes.put(unit.file(), scope);
        index.addQualifier(unit.packageText());
        var kinds =
                new Definition.Cases<>(
                        component ->
                                topLevel.add(
                                        add(ComponentDeclaration.topLevel(scope, component), seen)),
                        automaton -> bareAutomata.add(AutomatonSymbol.bare(automaton, scope)),
                        diagram -> diagrams.add(define(scope, diagram, seen)),
                        suite -> testSuites.add(new TestSuiteSymbol(scope, suite, this::symbol)));
        unit.definition().match(kinds);
    }

    /** Makes the symbol of a component, then those of the components inside it. */
    private ComponentSymbol add(ComponentDeclaration declaration, boolean seen) {
        Signature signature = new Signature(declaration, signatures::get);
        ComponentSymbol symbol = new ComponentSymbol(signature, symbols::get, reader);
        signatures.put(declaration, signature);
        symbols.put(signature, symbol);
        components.add(symbol);
        if (seen) {
            index.add(declaration);
            index.addQualifier(declaration.qualifiedName());
        }
        declaration.innerComponents().forEach(inner -> add(inner, seen));
        declaration.configurations().forEach(this::addConfiguration);
        return symbol;
    }

    /** Found by its name with its features, and nowhere where components are listed as written. */
    private void addConfiguration(ComponentDeclaration declaration) {
        Signature signature = new Signature(declaration, signatures::get);
        ComponentSymbol symbol = new ComponentSymbol(signature, symbols::get, reader);
        signatures.put(declaration, signature);
        symbols.put(signature, symbol);
        configured.add(symbol);
        declaration.innerComponents().forEach(this::addConfiguration);
    }

    private DiagramSymbol define(UnitScope scope, ClassDiagram diagram, boolean seen) {
        String name = Names.join(scope.unit().packageText(), diagram.name().text());
        List<DefinedType> types = new ArrayList<>();
        for (ClassDiagram.TypeDefinition node : diagram.types()) {
            types.add(define(scope, node, Names.join(name, node.name().text())));
        }
        if (seen) {
            index.addQualifier(name);
            types.forEach(index::add);
        }
        return new DiagramSymbol(scope.unit(), diagram, name, types);
    }

    private static DefinedType define(
            UnitScope scope, ClassDiagram.TypeDefinition node, String qualifiedName) {
        if (node instanceof ClassDiagram.EnumDefinition definition) {
            return new EnumSymbol(scope.unit(), definition, qualifiedName);
        }
        if (node instanceof ClassDiagram.NamedType definition) {
            return new OpaqueSymbol(scope.unit(), definition, qualifiedName);
        }
        return new ClassSymbol(
                scope.unit(), scope::type, (ClassDiagram.ClassDefinition) node, qualifiedName);
    }

    private ComponentSymbol symbol(ComponentDeclaration declaration) {
        return Objects.requireNonNull(symbols.get(signatures.get(declaration)));
    }

    public List<Unit> units() {
        return units;
    }

    /** The names that all files define, those included of which only the names are known. */
    public List<Outline> outlines() {
        return outlines.get();
    }

    private List<Outline> allOutlines() {
        return Stream.concat(units.stream().map(Outline::of), others.stream()).toList();
    }

    /** What the names in a file reach. */
    public UnitScope scope(Unit unit) {
        return Objects.requireNonNull(scopes.get(unit.file()));
    }

    /** The components that files are about, in the order of the units. */
    public List<ComponentSymbol> topLevelComponents() {
        return List.copyOf(topLevel);
    }

    /** All components; inner ones follow the one around them. */
    public List<ComponentSymbol> components() {
        return List.copyOf(components);
    }

    /**
     * All components that mean something by themselves: of what has features its configurations,
     * with what is inside them.
     */
    public List<ComponentSymbol> meantComponents() {
        return Stream.concat(
                        components.stream().filter(each -> !each.declaration().isOpen()),
                        configured.stream())
                .toList();
    }

    /** The configurations of a component with features; else itself. */
    public List<ComponentSymbol> configurations(ComponentSymbol component) {
        return component.declaration().isOpen()
                ? component.declaration().configurations().stream().map(this::symbol).toList()
                : List.of(component);
    }

    /** The components of a qualified name, {@code p.Outer.Inner} for inner ones. */
    public List<ComponentSymbol> components(String qualifiedName) {
        return index.components(qualifiedName).stream().map(this::symbol).toList();
    }

    public List<DiagramSymbol> diagrams() {
        return List.copyOf(diagrams);
    }

    /** The types of a qualified name, {@code p.Diagram.Type}. */
    public List<DefinedType> types(String qualifiedName) {
        return List.copyOf(index.types(qualifiedName));
    }

    /** The types that are reached as {@code p.Type}, without their diagram. */
    public List<DefinedType> typesOfPackage(String shortName) {
        return List.copyOf(index.typesOfPackage(shortName));
    }

    /** Automata in files of their own. */
    public List<AutomatonSymbol> bareAutomata() {
        return List.copyOf(bareAutomata);
    }

    public List<TestSuiteSymbol> testSuites() {
        return List.copyOf(testSuites);
    }

    /** Delays through compositions, and cycles without one. */
    public Delays delays() {
        return delays;
    }

    /**
     * Components that contain themselves: per group of them one shortest cycle, the first component
     * not repeated.
     */
    public List<List<ComponentSymbol>> subcomponentCycles() {
        return Parts.cycles(components);
    }

    /**
     * How many instances are in each component, at all levels. Of one that contains itself, those
     * inside itself do not count; beyond a million millions it is that number.
     */
    public Map<ComponentSymbol, Long> partCounts() {
        return Parts.counts(components);
    }
}
