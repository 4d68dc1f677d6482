package arcomat.semantics.expression;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.junit.jupiter.api.Test;

class IntervalTest {
    private static final Span PLACE = new SourceFile("A.arc", "1").span(0, 1);
    private static final Type INT = Type.IntegerType.of(Type.Width.INT);

    private static Expression constant(long number) {
        return new Expression.Constant(new Value.IntegerValue(number), INT, PLACE);
    }

    private static Expression sum(int terms, long each) {
        Expression sum = constant(each);
        for (int i = 1; i < terms; i++) {
            sum = new Expression.Binary(BinaryOperator.PLUS, sum, constant(each), INT, PLACE);
        }
        return sum;
    }

    /** Each level is looked at once: twice would be more than there is time for. */
    @Test
    void ofALongSumEachTermCountsOnce() {
        assertThat(Interval.of(sum(200, 3))).isEqualTo(Interval.of(600, 600));
    }

    @Test
    void whatDoesNotFitLiesAnywhere() {
        assertThat(Interval.of(sum(2, Integer.MAX_VALUE))).isEqualTo(Interval.ofWidth(INT));
        assertThat(Interval.wraps(sum(2, Integer.MAX_VALUE))).isTrue();
        assertThat(Interval.wraps(sum(2, 1))).isFalse();
    }
}
