package arcomat.symbols.expressions;

import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Block;

import java.util.ArrayList;
import java.util.List;

/** The right-hand side of an item, or a cell of a table, with types. */
public sealed interface ItemValue {
    Block.Value node();

    /** The expressions in it, in text order. */
    List<Typed> expressions();

    record Alternatives(Block.Alternatives node, List<ItemValue> values) implements ItemValue {
        public Alternatives {
            values = List.copyOf(values);
        }

        @Override
        public List<Typed> expressions() {
            List<Typed> all = new ArrayList<>();
            values.forEach(value -> all.addAll(value.expressions()));
            return all;
        }
    }

    record Sequence(Block.Sequence node, List<Typed> expressions) implements ItemValue {
        public Sequence {
            expressions = List.copyOf(expressions);
        }
    }

    record Single(Block.Single node, Typed expression) implements ItemValue {
        @Override
        public List<Typed> expressions() {
            return List.of(expression);
        }
    }

    /** {@code --}, {@code ?} and {@code *}: told apart by the node. */
    record Mark(Block.Value node) implements ItemValue {
        @Override
        public List<Typed> expressions() {
            return List.of();
        }
    }

    /** Types a value for a place of a type. */
    static ItemValue of(Block.Value node, ValueScope scope, TypeSymbol expected) {
        if (node instanceof Block.Alternatives alternatives) {
            return new Alternatives(
                    alternatives,
                    alternatives.values().stream().map(v -> of(v, scope, expected)).toList());
        }
        if (node instanceof Block.Sequence sequence) {
            return new Sequence(
                    sequence,
                    sequence.messages().stream()
                            .map(m -> ExpressionTyping.type(m, scope, expected))
                            .toList());
        }
        if (node instanceof Block.Single single) {
            return new Single(single, ExpressionTyping.type(single.expression(), scope, expected));
        }
        return new Mark(node);
    }
}
