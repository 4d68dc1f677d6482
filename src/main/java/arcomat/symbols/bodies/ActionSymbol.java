package arcomat.symbols.bodies;

import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.Statement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** A statement with what its names mean. */
public sealed interface ActionSymbol {
    Statement node();

    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R sequence(Sequence sequence);

        R assign(Assign assign);

        R choose(Choose choose);

        R declare(Declare declare);
    }

    /** Shows the action and those in it, in text order. */
    default void walk(Consumer<ActionSymbol> visitor) {
        visitor.accept(this);
    }

    /** What is assigned in it, whether or not it comes to that. */
    default List<ItemSymbol> items() {
        return all(Assign.class).stream().map(Assign::item).toList();
    }

    default List<Choose> choices() {
        return all(Choose.class);
    }

    default List<Declare> declarations() {
        return all(Declare.class);
    }

    /** Those of one form, in text order. */
    private <A extends ActionSymbol> List<A> all(Class<A> form) {
        List<A> all = new ArrayList<>();
        walk(
                each -> {
                    if (form.isInstance(each)) {
                        all.add(form.cast(each));
                    }
                });
        return List.copyOf(all);
    }

    record Sequence(Statement.Sequence node, List<ActionSymbol> actions) implements ActionSymbol {
        public Sequence {
            actions = List.copyOf(actions);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.sequence(this);
        }

        @Override
        public void walk(Consumer<ActionSymbol> visitor) {
            visitor.accept(this);
            actions.forEach(each -> each.walk(visitor));
        }
    }

    record Assign(Statement.Assignment node, ItemSymbol item) implements ActionSymbol {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.assign(this);
        }
    }

    /**
     * A name for a value.
     *
     * @param hidden what has the same name already
     */
    record Local(VariableSymbol variable, Optional<ValueSymbol> hidden) {}

    record Choose(
            Statement.Choice node,
            Typed condition,
            ActionSymbol then,
            Optional<ActionSymbol> otherwise)
            implements ActionSymbol {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.choose(this);
        }

        @Override
        public void walk(Consumer<ActionSymbol> visitor) {
            visitor.accept(this);
            then.walk(visitor);
            otherwise.ifPresent(each -> each.walk(visitor));
        }
    }

    /** Names for values, each in sight of the next one. */
    record Declare(Statement.Locals node, List<Local> locals) implements ActionSymbol {
        public Declare {
            locals = List.copyOf(locals);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.declare(this);
        }
    }
}
