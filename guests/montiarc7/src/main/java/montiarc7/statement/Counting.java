package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.TypeContext;
import montiarc7.grammar.MontiArc7Parser.VariableContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.Optional;

/** Local variables with which loops count: their values are known while an action is read. */
final class Counting {
    private final Course course;
    private final Lacks lacks;

    Counting(Course course, Lacks lacks) {
        this.course = course;
        this.lacks = lacks;
    }

    boolean has(String variable) {
        return course.known.values().containsKey(variable);
    }

    /** Whether a variable counts from now on. */
    boolean begin(TypeContext type, VariableContext variable) {
        if (variable.expression() == null || !type.getText().matches("int|Integer|long|Long")) {
            return false;
        }
        Optional<Number> value = new Arithmetic(course.known).number(variable.expression());
        Number like = type.getText().matches("[lL]ong") ? (Number) 0L : (Number) 0;
        value.ifPresent(
                each ->
                        course.known =
                                course.known.with(variable.name().getText(), like(like, each)));
        return value.isPresent();
    }

    /** What a variable that counts is afterwards. */
    void change(ParserRuleContext place, String name, String operator, Optional<Number> value) {
        Number before = course.known.values().get(name);
        Optional<Number> after =
                operator.equals("=")
                        ? value
                        : value.flatMap(
                                        each ->
                                                Arithmetic.calculated(
                                                        operator.substring(0, 1), before, each))
                                .map(Number.class::cast);
        if (after.isEmpty() || course.fixed.contains(name)) {
            lacks.missing(
                    Lack.STATEMENT,
                    place,
                    "a loop counts with '%s', which is known here only while a model runs; let it count from one number to another"
                            .formatted(name));
            return;
        }
        course.known = course.known.with(name, like(before, after.get()));
    }

    /** As Java's compound assignments have it. */
    private static Number like(Number before, Number after) {
        return before instanceof Long ? (Number) after.longValue() : (Number) after.intValue();
    }
}
