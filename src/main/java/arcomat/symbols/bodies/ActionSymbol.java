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
        List<ItemSymbol> items = new ArrayList<>();
        walk(
                each -> {
                    if (each instanceof Assign assign) {
                        items.add(assign.item());
                    }
                });
        return List.copyOf(items);
    }

    default List<Choose> choices() {
        List<Choose> choices = new ArrayList<>();
        walk(
                each -> {
                    if (each instanceof Choose choose) {
                        choices.add(choose);
                    }
                });
        return List.copyOf(choices);
    }

    default List<Declare> declarations() {
        List<Declare> declarations = new ArrayList<>();
        walk(
                each -> {
                    if (each instanceof Declare declare) {
                        declarations.add(declare);
                    }
                });
        return List.copyOf(declarations);
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
