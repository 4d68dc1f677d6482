package arcomat.symbols.names;

import arcomat.tree.ClassDiagram;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** A class of a class diagram. */
public final class ClassSymbol extends DefinedType {
    /** An attribute with its type; {@code owner} is the class that declares it. */
    public record AttributeSymbol(
            ClassSymbol owner, ClassDiagram.Attribute node, Resolution<TypeSymbol> resolution) {
        public String name() {
            return node.name().text();
        }

        public TypeSymbol type() {
            return resolution.found().orElse(UnknownType.UNKNOWN);
        }
    }

    private final Function<TypeReference, Resolution<TypeSymbol>> types;
    private final ClassDiagram.ClassDefinition node;
    private final Lazy<Resolution<ClassSymbol>> superClass = new Lazy<>(this::resolveSuperClass);
    private final Lazy<List<AttributeSymbol>> attributes = new Lazy<>(this::computeAttributes);

    /**
     * @param types what types mean in its file
     */
    public ClassSymbol(
            Unit unit,
            Function<TypeReference, Resolution<TypeSymbol>> types,
            ClassDiagram.ClassDefinition node,
            String qualifiedName) {
        super(unit, qualifiedName);
        this.types = types;
        this.node = node;
    }

    @Override
    public ClassDiagram.ClassDefinition node() {
        return node;
    }

    /** The class it extends; unknown also where an enum or a built-in type is named. */
    public Optional<Resolution<ClassSymbol>> superClass() {
        return node.superClass().map(reference -> superClass.get());
    }

    private Resolution<ClassSymbol> resolveSuperClass() {
        TypeReference reference = node.superClass().orElseThrow();
        Resolution<TypeSymbol> type = types.apply(reference);
        if (type.found().isPresent() && !(type.found().get() instanceof ClassSymbol)) {
            return Resolution.unknown();
        }
        return type.map(ClassSymbol.class::cast);
    }

    /** This class and those above it, nearest first; ends before a class would come again. */
    public List<ClassSymbol> lineage() {
        Set<ClassSymbol> line = new LinkedHashSet<>();
        ClassSymbol current = this;
        while (current != null && line.add(current)) {
            current = current.superClass().flatMap(Resolution::found).orElse(null);
        }
        return List.copyOf(line);
    }

    /** Whether the class extends itself over any number of steps. */
    public boolean isItsOwnAncestor() {
        List<ClassSymbol> line = lineage();
        ClassSymbol top = line.get(line.size() - 1);
        return top.superClass().flatMap(Resolution::found).filter(this::equals).isPresent();
    }

    /** All attributes, inherited ones first. */
    public List<AttributeSymbol> attributes() {
        return attributes.get();
    }

    private List<AttributeSymbol> computeAttributes() {
        List<AttributeSymbol> all = new ArrayList<>();
        List<ClassSymbol> line = lineage();
        for (int i = line.size() - 1; i >= 0; i--) {
            ClassSymbol owner = line.get(i);
            for (ClassDiagram.Attribute attribute : owner.node.attributes()) {
                all.add(new AttributeSymbol(owner, attribute, owner.types.apply(attribute.type())));
            }
        }
        return List.copyOf(all);
    }

    public Optional<AttributeSymbol> attribute(String name) {
        return attributes().stream().filter(a -> a.name().equals(name)).findFirst();
    }

    @Override
    public boolean isObject() {
        return true;
    }
}
