package arcomat.semantics.statement;

import arcomat.model.Automaton;
import arcomat.model.Type;
import arcomat.model.Variable;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * Names the cells in which values stand while statements are carried out: those of the variables of
 * an automaton, and those of local ones. A value has no range before it is kept.
 */
final class Cells {
    private final boolean aside;
    private final Set<String> own = new HashSet<>();
    private final Map<String, Variable> now = new HashMap<>();
    private final Map<String, Variable> all = new LinkedHashMap<>();

    /**
     * No cells yet.
     *
     * @param aside whether variables of the automaton change at the end, so that their new values
     *     stand in cells beside them
     */
    Cells(Automaton automaton, boolean aside) {
        this.aside = aside;
        automaton.variables().forEach(each -> own.add(each.name()));
    }

    /** Whether the automaton has a variable of a name. */
    boolean isOwn(String variable) {
        return own.contains(variable);
    }

    boolean has(String variable) {
        return now.containsKey(variable);
    }

    /** All cells that there have been. */
    Collection<Variable> all() {
        return all.values();
    }

    /** The cell of a variable, which is made where there is none. */
    Variable of(Variable variable) {
        String key = variable.name();
        if (!now.containsKey(key)) {
            boolean copied = aside && isOwn(key);
            add(key, wide(variable, copied ? "next " + key : key));
        }
        return of(key);
    }

    /** The cell of a variable that has one. */
    Variable of(String variable) {
        return Objects.requireNonNull(now.get(variable));
    }

    /** The cell of a name. */
    Variable called(String cell) {
        return Objects.requireNonNull(all.get(cell));
    }

    /** A local that is called as an earlier one shares its cell if the type is the same. */
    Variable declared(Variable local) {
        String name = local.name();
        Variable cell = wide(local, name);
        for (int i = 2; all.containsKey(cell.name()) && !isOfType(cell); i++) {
            cell = wide(local, name + " " + i);
        }
        add(name, cell);
        return cell;
    }

    private void add(String variable, Variable cell) {
        now.put(variable, cell);
        all.put(cell.name(), cell);
    }

    private boolean isOfType(Variable cell) {
        return called(cell.name()).type().equals(cell.type());
    }

    /** A variable of that name without a range. */
    static Variable wide(Variable variable, String name) {
        Type type =
                variable.type() instanceof Type.IntegerType integer
                        ? Type.IntegerType.of(integer.width())
                        : variable.type();
        return new Variable(name, type, variable.initial(), variable.span());
    }
}
