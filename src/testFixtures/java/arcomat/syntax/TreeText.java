package arcomat.syntax;

import arcomat.source.Span;
import arcomat.tree.Behaviour;
import arcomat.tree.Block.Single;
import arcomat.tree.Expression;
import arcomat.tree.Expression.Binary;
import arcomat.tree.Expression.JavaExpression;
import arcomat.tree.Expression.Literal;
import arcomat.tree.Expression.Reference;
import arcomat.tree.Expression.Unary;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit.Comment;

import java.lang.reflect.RecordComponent;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A tree as text, without places: {@code (Kind field: value ..)}, what is absent left out. Two
 * trees are the same if and only if their texts are.
 */
public final class TreeText {
    private static final int WIDTH = 100;

    private static final Map<Class<?>, RecordComponent[]> FIELDS = new ConcurrentHashMap<>();

    /** Parts are asked for their texts at each line that could hold them. */
    private final Map<Object, String> flats = new IdentityHashMap<>();

    private TreeText() {}

    public static String of(Object node) {
        return new TreeText().pretty(node, "") + "\n";
    }

    private String pretty(Object value, String indent) {
        String flat = flat(value);
        if (indent.length() + flat.length() <= WIDTH || isOneLine(value)) {
            return flat;
        }
        String inner = indent + "  ";
        if (value instanceof List<?> list) {
            StringBuilder text = new StringBuilder("[");
            list.forEach(e -> text.append("\n").append(inner).append(pretty(e, inner)));
            return text.append("]").toString();
        }
        if (value instanceof Optional<?> optional) {
            return pretty(optional.get(), indent);
        }
        StringBuilder text = new StringBuilder("(" + value.getClass().getSimpleName());
        for (RecordComponent field : fields(value)) {
            Object content = content(value, field);
            if (isShown(content)) {
                text.append("\n").append(inner).append(field.getName()).append(": ");
                text.append(pretty(content, inner));
            }
        }
        return text.append(")").toString();
    }

    private String flat(Object value) {
        String known = flats.get(value);
        if (known == null) {
            known = written(value);
            flats.put(value, known);
        }
        return known;
    }

    private String written(Object value) {
        if (value instanceof Optional<?> optional) {
            return flat(optional.get());
        }
        if (value instanceof List<?> list) {
            return "[" + String.join(" ", list.stream().map(this::flat).toList()) + "]";
        }
        if (value instanceof Reference reference) {
            return reference.name().text();
        }
        if (value instanceof Binary binary) {
            return "("
                    + binary.operator()
                    + " "
                    + flat(binary.left())
                    + " "
                    + flat(binary.right())
                    + ")";
        }
        if (value instanceof Unary unary) {
            return "(" + unary.operator() + " " + flat(unary.operand()) + ")";
        }
        if (value instanceof JavaExpression java) {
            return "(JavaExpression '" + java.text().replaceAll("\\s+", "") + "')";
        }
        if (value instanceof Single single) {
            return flat(single.expression());
        }
        if (value instanceof Literal literal) {
            return literal.kind() + ":" + literal.text();
        }
        if (value instanceof Comment comment) {
            return quoted(comment.text());
        }
        if (value instanceof String string) {
            return quoted(string);
        }
        if (!(value instanceof Record) || value instanceof Name || value instanceof QualifiedName) {
            return value.toString();
        }
        StringBuilder text = new StringBuilder("(" + value.getClass().getSimpleName());
        for (RecordComponent field : fields(value)) {
            Object content = content(value, field);
            if (isShown(content)) {
                text.append(" ").append(field.getName()).append(": ").append(flat(content));
            }
        }
        return text.append(")").toString();
    }

    private static boolean isOneLine(Object value) {
        return value instanceof Expression || value instanceof Comment || value instanceof String;
    }

    private static boolean isShown(Object content) {
        return !(content instanceof Span
                || content instanceof Optional<?> optional && optional.isEmpty()
                || content instanceof List<?> list && list.isEmpty()
                || Boolean.FALSE.equals(content)
                || Integer.valueOf(0).equals(content));
    }

    private static String quoted(String text) {
        return "'" + text.replaceAll("\\s+", " ").strip() + "'";
    }

    private static RecordComponent[] fields(Object value) {
        return FIELDS.computeIfAbsent(value.getClass(), Class::getRecordComponents);
    }

    private static Object content(Object value, RecordComponent field) {
        if (value instanceof Behaviour.Foreign foreign && field.getName().equals("body")) {
            return foreign.body().text().replaceAll("\\s+", ""); // set by the formatter, too
        }
        try {
            var accessor = field.getAccessor();
            accessor.setAccessible(true);
            return accessor.invoke(value);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }
}
