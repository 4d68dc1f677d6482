package arcomat.symbols.names;

import arcomat.tree.ClassDiagram;
import arcomat.tree.Expression;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Import;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * What the names in one file reach. A name is looked for, and the first place that has it wins: the
 * class diagram itself, imports of that very name, the package of the file, the built-in types, the
 * name as fully qualified, imports with a wildcard. For {@code a.b.C} the first part decides. A
 * type that is not found like this is looked for without its diagram, as if it were a class of
 * Java.
 */
public final class UnitScope {
    private final Unit unit;
    private final Index index;
    private final String home;
    private final Lazy<Map<String, List<Import>>> singleImports = new Lazy<>(this::singleImports);
    private final Lazy<List<Import>> wildcardImports = new Lazy<>(this::wildcardImports);
    private final Lazy<Boolean> leadsNowhere = new Lazy<>(this::someWildcardLeadsNowhere);

    public UnitScope(Unit unit, Index index) {
        this.unit = unit;
        this.index = index;
        this.home = home(unit);
    }

    /** Where the siblings of the types of a class diagram are; else the package. */
    private static String home(Unit unit) {
        return unit.definition() instanceof ClassDiagram diagram
                ? Names.join(unit.packageText(), diagram.name().text())
                : unit.packageText();
    }

    public Unit unit() {
        return unit;
    }

    /** The message type that a name stands for, built-in types included; no type parameters. */
    public Resolution<TypeSymbol> type(QualifiedName name) {
        Optional<BuiltinType> builtin = BuiltinType.named(name.text());
        if (builtin.isPresent() && !isDefinedHere(name)) {
            return new Resolution.Found<>(builtin.get());
        }
        Optional<String> java = javaName(name);
        if (java.isPresent()) {
            return new Resolution.Found<>(JavaTypes.named(java.get()));
        }
        Resolution<TypeSymbol> defined = lookUp(name, index::types).map(type -> type);
        return defined.isUnknown() && component(name).isUnknown() ? otherwise(name) : defined;
    }

    /** What nothing has by its full name. */
    private Resolution<TypeSymbol> otherwise(QualifiedName name) {
        List<TypeSymbol> java = javaInSight(name).map(JavaTypes::named).toList();
        if (!java.isEmpty()) {
            return Resolution.of(java);
        }
        Resolution<TypeSymbol> defined = lookUp(name, index::typesOfPackage).map(type -> type);
        if (!defined.isUnknown()) {
            return defined;
        }
        boolean mayBeOwn = index.isExcusedType(Names.join(unit.packageText(), name.text()));
        return mayBeOwn
                ? Resolution.excused()
                : Resolution.of(javaOfOlderTools(name).map(JavaTypes::named));
    }

    /**
     * What a name means to Java where nothing else has it: a type of its packages that are imported
     * as a whole, and of {@code java.lang}.
     */
    private Stream<String> javaInSight(QualifiedName name) {
        return Stream.concat(
                        Stream.of("java.lang"),
                        wildcardImports.get().stream().map(each -> each.name().text()))
                .distinct()
                .map(each -> Names.join(each, name.text()))
                .filter(JavaTypes::isKnown);
    }

    /** Older tools saw all of {@code java.util} without an import. */
    private static Optional<String> javaOfOlderTools(QualifiedName name) {
        return Optional.of(Names.join("java.util", name.text())).filter(JavaTypes::isKnown);
    }

    /** The full name of a type of Java that only older tools see without an import. */
    public Optional<String> missingImport(QualifiedName name) {
        Optional<String> assumed = javaOfOlderTools(name);
        return assumed.isPresent()
                        && javaInSight(name).findAny().isEmpty()
                        && type(name).equals(new Resolution.Found<>(JavaTypes.named(assumed.get())))
                        && importOf(name).isEmpty()
                ? assumed
                : Optional.empty();
    }

    /** A type as written, with its range; outside of components there are no type parameters. */
    public Resolution<TypeSymbol> type(TypeReference reference) {
        return TypeReferences.resolve(reference, this::type);
    }

    /** The component that a name stands for, inner components by their path only. */
    public Resolution<ComponentDeclaration> component(QualifiedName name) {
        return lookUp(name, index::components);
    }

    /**
     * What an import leads to. With a wildcard: unknown unless a package, a diagram or a component
     * has that name. What is not known of the Java library is excused: what uses it is reported.
     */
    public Resolution<QualifiedName> target(Import imported) {
        String name = imported.name().text();
        if (imported.wildcard() ? leadsSomewhere(name) : exists(name) || isShort(name)) {
            return new Resolution.Found<>(imported.name());
        }
        boolean excused =
                JavaTypes.isJava(name)
                        || index.isExcused(name)
                        || (imported.wildcard()
                                ? index.hasBrokenFileIn(name)
                                : index.isExcusedType(name));
        return excused ? Resolution.excused() : Resolution.unknown();
    }

    /**
     * Whether what an import leads to is open: to something in a file that did not parse, or to the
     * same as another import that leads there.
     */
    public boolean mayLeadFurther(Import imported) {
        return imported.wildcard()
                ? index.hasBrokenFileIn(imported.name().text())
                : Objects.requireNonNull(singleImports.get().get(imported.name().last().text()))
                        .stream()
                        .anyMatch(each -> !target(each).isFound());
    }

    private boolean leadsSomewhere(String qualifier) {
        return index.isQualifier(qualifier) || JavaTypes.isQualifier(qualifier);
    }

    /** The full name of what can only be of the Java library, since no model can define it. */
    private Optional<String> javaName(QualifiedName name) {
        if (JavaTypes.isJava(name.text())) {
            return Optional.of(name.text());
        }
        return singleImports.get().getOrDefault(Names.first(name), List.of()).stream()
                .map(each -> each.name().text() + Names.afterFirst(name))
                .filter(JavaTypes::isJava)
                .findFirst();
    }

    /** The import through which a name is reached, if it is reached through one. */
    public Optional<Import> importOf(QualifiedName name) {
        List<Import> single = singleImports.get().get(Names.first(name));
        if (single != null) {
            return Optional.of(single.get(0));
        }
        if (exists(Names.join(unit.packageText(), name.text()))) {
            return Optional.empty();
        }
        String first = Names.first(name);
        return wildcard(first, this::exists).or(() -> wildcardOfPackage(first));
    }

    private Optional<Import> wildcard(String first, Predicate<String> known) {
        return wildcardImports.get().stream()
                .filter(i -> known.test(Names.join(i.name().text(), first)))
                .findFirst();
    }

    /** In the own package, no import is needed for a type without its diagram. */
    private Optional<Import> wildcardOfPackage(String first) {
        return isShort(Names.join(unit.packageText(), first))
                ? Optional.empty()
                : wildcard(first, this::isShort);
    }

    private boolean exists(String name) {
        return !index.types(name).isEmpty()
                || !index.components(name).isEmpty()
                || index.isQualifier(name)
                || JavaTypes.isKnown(name);
    }

    /** Whether types have that name without their diagram. */
    private boolean isShort(String name) {
        return !index.typesOfPackage(name).isEmpty();
    }

    /** The enumeration constant that {@code Enum.CONST}, qualified or not, stands for. */
    public Resolution<TypeSymbol> qualifierOf(Expression.Reference reference) {
        List<arcomat.tree.Name> parts = reference.name().parts();
        return type(new QualifiedName(reference.span(), parts.subList(0, parts.size() - 1)));
    }

    private boolean isDefinedHere(QualifiedName name) {
        return !index.types(Names.join(home, name.text())).isEmpty()
                || singleImports.get().getOrDefault(name.text(), List.of()).stream()
                        .anyMatch(i -> !index.types(i.name().text()).isEmpty());
    }

    private <S> Resolution<S> lookUp(QualifiedName name, Function<String, List<S>> table) {
        String text = name.text();
        Set<S> found = new LinkedHashSet<>();
        List<Import> single = singleImports.get().getOrDefault(Names.first(name), List.of());
        if (unit.definition() instanceof ClassDiagram) {
            found.addAll(table.apply(Names.join(home, text)));
        }
        if (found.isEmpty()) {
            for (Import imported : single) {
                found.addAll(table.apply(imported.name().text() + Names.afterFirst(name)));
            }
        }
        if (found.isEmpty()) {
            found.addAll(table.apply(Names.join(unit.packageText(), text)));
        }
        if (found.isEmpty()) {
            found.addAll(table.apply(text));
        }
        if (found.isEmpty()) {
            for (Import imported : wildcardImports.get()) {
                found.addAll(table.apply(Names.join(imported.name().text(), text)));
            }
        }
        return found.isEmpty() ? missing(name, single) : Resolution.of(List.copyOf(found));
    }

    /** Nothing was found: is that the fault of this name? */
    private <S> Resolution<S> missing(QualifiedName name, List<Import> single) {
        String text = name.text();
        boolean excused =
                single.stream().anyMatch(i -> isElsewhere(i, name))
                        || index.isExcused(Names.join(unit.packageText(), text))
                        || index.isExcused(Names.join(home, text))
                        || !name.isSimple() && index.isExcused(text)
                        || leadsNowhere.get()
                        || wildcardImports.get().stream()
                                .anyMatch(i -> index.isExcused(i.name().text() + "." + text));
        return excused ? Resolution.excused() : Resolution.unknown();
    }

    private boolean isElsewhere(Import imported, QualifiedName name) {
        return !target(imported).isFound()
                || index.isExcused(imported.name().text() + Names.afterFirst(name));
    }

    private boolean someWildcardLeadsNowhere() {
        return wildcardImports.get().stream()
                .anyMatch(i -> !target(i).isFound() && !JavaTypes.isJava(i.name().text()));
    }

    private Map<String, List<Import>> singleImports() {
        Map<String, List<Import>> map = new HashMap<>();
        for (Import imported : unit.imports()) {
            if (!imported.wildcard()) {
                map.computeIfAbsent(imported.name().last().text(), n -> new ArrayList<>(1))
                        .add(imported);
            }
        }
        return map;
    }

    private List<Import> wildcardImports() {
        return unit.imports().stream().filter(Import::wildcard).toList();
    }
}
