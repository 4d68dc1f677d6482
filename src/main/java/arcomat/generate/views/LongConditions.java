package arcomat.generate.views;

import arcomat.generate.language.Text;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.Formula;
import arcomat.generate.text.FormulaBuilder;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.AtomicView.ConditionView;
import arcomat.model.Valuation;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Conditions of transitions. Virtual machines do not compile long methods, and have no room for
 * very long ones: of a long row of operands some share a method each, and so do parts of a
 * condition that is judged.
 */
final class LongConditions {
    /** How many words of a condition that is judged stand in one expression. */
    private static final int MOST_JUDGED_WORDS = 60;

    private final ExpressionWriter expressions;
    private final MemberNames members;
    private final List<ConditionView> methods = new ArrayList<>();

    LongConditions(FileContext context) {
        this.expressions = context.expressions();
        this.members = context.members();
    }

    /** The text of a condition, with calls of methods where it is long. */
    String text(int transition, Formula condition) {
        return new Cutting(transition).text(condition).text();
    }

    /** The methods that were called for, in that order. */
    List<ConditionView> methods() {
        return methods;
    }

    /** One condition that is cut into parts. */
    private final class Cutting {
        private final int transition;
        private final Map<Formula, Integer> counted = new IdentityHashMap<>();
        private int parts;

        Cutting(int transition) {
            this.transition = transition;
        }

        private Text text(Formula condition) {
            return expressions.of(shortened(called(condition)));
        }

        /** The same with calls in the place of what is judged. */
        private Formula called(Formula f) {
            return f.match(
                    new Formula.Cases<>(
                            carries -> carries,
                            is -> is,
                            test -> test,
                            not -> new Formula.Not(called(not.operand())),
                            row -> Formula.Row.of(row.all(), called(row.operands())),
                            this::called));
        }

        private List<Formula> called(List<Formula> operands) {
            return operands.stream().map(this::called).toList();
        }

        private Formula called(Formula.Judged judged) {
            ExpressionWriter here = expressions.at(judged.place());
            Text known = judged.condition().valuation().fold(new Writing(here));
            return Formula.Test.of(here.judgedTrue(known), judged.mayFail());
        }

        private Formula shortened(Formula f) {
            if (!expressions.calls() || words(f) <= MethodSize.MOST_WORDS) {
                return f;
            }
            if (f instanceof Formula.Not not) {
                return new Formula.Not(shortened(not.operand()));
            }
            return f instanceof Formula.Row row ? shortened(row.operands(), row.all()) : f;
        }

        private Formula shortened(List<Formula> operands, boolean all) {
            List<Formula> calls = new ArrayList<>();
            List<Formula> some = new ArrayList<>();
            int words = 0;
            for (Formula operand : operands) {
                Formula part = shortened(operand);
                int more = words(part);
                if (!some.isEmpty() && words + more > MethodSize.MOST_WORDS) {
                    calls.add(call(Formula.Row.of(all, some)));
                    some.clear();
                    words = 0;
                }
                some.add(part);
                words += more;
            }
            Formula rest = Formula.Row.of(all, some);
            calls.add(calls.isEmpty() ? rest : call(rest));
            return calls.size() == 1 ? rest : shortened(Formula.Row.of(all, calls));
        }

        /** Of the text: what nests is not written to be counted. */
        private int words(Formula f) {
            if (f instanceof Formula.Not not) {
                return words(not.operand());
            }
            if (f instanceof Formula.Row row && !row.operands().isEmpty()) {
                return row.operands().stream().mapToInt(this::words).sum();
            }
            return counted.computeIfAbsent(
                    f, each -> MethodSize.words(expressions.of(each).text()));
        }

        private Formula call(Formula condition) {
            return Formula.Test.of(call(expressions.of(condition), false, ""), true);
        }

        /**
         * @param judged whether the method says what is known, or else whether something holds
         * @param wrong what is known where it goes wrong; empty where that is an error
         */
        private Text call(Text text, boolean judged, String wrong) {
            String method = members.local("condition" + transition + "part", parts++);
            methods.add(new ConditionView(method, text.text(), judged, wrong));
            return expressions.call(method);
        }

        /** Writes what is known of a condition. */
        private final class Writing implements Valuation.Cases<Text> {
            private final ExpressionWriter here;

            Writing(ExpressionWriter here) {
                this.here = here;
            }

            @Override
            public Text part(Valuation.Part part) {
                Formula defined = new FormulaBuilder(here).of(part.defined());
                Formula value = new FormulaBuilder(here).of(part.value());
                Text known = tried(value, here.judged("of", text(value)), "late");
                if (defined.equals(Formula.TRUE)) {
                    return known;
                }
                Text undefined = here.judged("undefined");
                return tried(defined, here.choice(text(defined), known, undefined), "wrong");
            }

            private Text tried(Formula condition, Text known, String wrong) {
                return condition.mayFail() ? call(known, true, here.judged(wrong).text()) : known;
            }

            @Override
            public Text not(Text operand) {
                return judged("not", operand);
            }

            @Override
            public Text row(boolean all, Text left, Text right) {
                return judged(all ? "and" : "or", left, right);
            }

            @Override
            public Text comparison(boolean equal, Text left, Text right) {
                Text same = judged("equal", left, right);
                return equal ? same : not(same);
            }

            @Override
            public Text choice(Text condition, Text then, Text otherwise) {
                return judged("choose", condition, then, otherwise);
            }

            private Text judged(String form, Text... operands) {
                Text text = here.judged(form, operands);
                return MethodSize.words(text.text()) > MOST_JUDGED_WORDS
                        ? call(text, true, "")
                        : text;
            }
        }
    }
}
