package arcomat.symbols.expressions;

import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Block;

import java.util.List;
import java.util.function.UnaryOperator;

/** The right-hand side of an item, or a cell of a table, with types. */
public sealed interface ItemValue {
    Block.Value node();

    /** The expressions in it, in text order. */
    List<Typed> expressions();

    /** The same with other expressions. */
    ItemValue map(UnaryOperator<Typed> change);

    record Alternatives(Block.Alternatives node, List<ItemValue> values) implements ItemValue {
        public Alternatives {
            values = List.copyOf(values);
        }

        @Override
        public List<Typed> expressions() {
            return values.stream().flatMap(value -> value.expressions().stream()).toList();
        }

        @Override
        public ItemValue map(UnaryOperator<Typed> change) {
            return new Alternatives(node, values.stream().map(v -> v.map(change)).toList());
        }
    }

    record Sequence(Block.Sequence node, List<Typed> expressions) implements ItemValue {
        public Sequence {
            expressions = List.copyOf(expressions);
        }

        @Override
        public ItemValue map(UnaryOperator<Typed> change) {
            return new Sequence(node, expressions.stream().map(change).toList());
        }
    }

    record Single(Block.Single node, Typed expression) implements ItemValue {
        @Override
        public List<Typed> expressions() {
            return List.of(expression);
        }

        @Override
        public ItemValue map(UnaryOperator<Typed> change) {
            return new Single(node, change.apply(expression));
        }
    }

    /** {@code --}, {@code ?} and {@code *}: told apart by the node. */
    record Mark(Block.Value node) implements ItemValue {
        @Override
        public List<Typed> expressions() {
            return List.of();
        }

        @Override
        public ItemValue map(UnaryOperator<Typed> change) {
            return this;
        }
    }

    /** Types a value for a place of a type. */
    static ItemValue of(Block.Value node, ValueScope scope, TypeSymbol expected) {
        return node.match(new ValueTyping(scope, expected));
    }

    /** The value without complaints about names that an expected type might have explained. */
    default ItemValue withoutUnknownNames() {
        return map(Typed::withoutUnknownNames);
    }
}
