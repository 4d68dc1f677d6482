package arcomat.symbols.names;

import arcomat.tree.ClassDiagram;
import arcomat.tree.Name;
import arcomat.tree.Unit;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;

/** An enumeration of a class diagram. */
public final class EnumSymbol extends DefinedType {
    private final ClassDiagram.EnumDefinition node;
    private final List<String> constants;
    private final Lazy<Map<String, Integer>> ordinals = new Lazy<>(this::computeOrdinals);

    public EnumSymbol(Unit unit, ClassDiagram.EnumDefinition node, String qualifiedName) {
        super(unit, qualifiedName);
        this.node = node;
        this.constants = node.constants().stream().map(Name::text).toList();
    }

    private Map<String, Integer> computeOrdinals() {
        Map<String, Integer> map = new HashMap<>();
        for (int i = 0; i < constants.size(); i++) {
            map.putIfAbsent(constants.get(i), i);
        }
        return map;
    }

    @Override
    public ClassDiagram.EnumDefinition node() {
        return node;
    }

    /** The constants as declared, duplicates included. */
    public List<String> constants() {
        return constants;
    }

    /** The position of a constant, from 0. */
    public OptionalInt ordinal(String constant) {
        Integer ordinal = ordinals.get().get(constant);
        return ordinal == null ? OptionalInt.empty() : OptionalInt.of(ordinal);
    }
}
