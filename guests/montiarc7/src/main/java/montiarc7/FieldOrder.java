package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ElementContext;
import montiarc7.grammar.MontiArc7Parser.FieldContext;
import montiarc7.grammar.MontiArc7Parser.FieldElementContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;

import org.antlr.v4.runtime.tree.ParseTree;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Fields begin with values that may be calculated from those of other ones, which stand before them
 * in Arcomat and anywhere in MontiArc.
 */
final class FieldOrder {
    private final Map<String, FieldElementContext> declared = new HashMap<>();
    private final Set<FieldElementContext> ordered = new LinkedHashSet<>();
    private final Set<FieldElementContext> begun = new HashSet<>();

    private FieldOrder(List<ElementContext> elements) {
        for (ElementContext each : elements) {
            if (each instanceof FieldElementContext fields) {
                fields.field().forEach(one -> declared.put(one.name().getText(), fields));
            }
        }
    }

    /** The same elements; only fields change their places, and only where one reads a later one. */
    static List<ElementContext> of(List<ElementContext> elements) {
        FieldOrder order = new FieldOrder(elements);
        for (ElementContext each : elements) {
            if (each instanceof FieldElementContext fields) {
                order.add(fields);
            }
        }
        Iterator<FieldElementContext> next = order.ordered.iterator();
        List<ElementContext> all = new ArrayList<>();
        elements.forEach(each -> all.add(each instanceof FieldElementContext ? next.next() : each));
        return all;
    }

    private void add(FieldElementContext fields) {
        if (begun.add(fields)) {
            for (FieldContext each : fields.field()) {
                read(each.expression());
            }
            ordered.add(fields);
        }
    }

    private void read(ParseTree expression) {
        if (expression instanceof NameExpressionContext name
                && declared.containsKey(name.getText())) {
            add(declared.get(name.getText()));
        }
        for (int i = 0; i < expression.getChildCount(); i++) {
            read(expression.getChild(i));
        }
    }
}
