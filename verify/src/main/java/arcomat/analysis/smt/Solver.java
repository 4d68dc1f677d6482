package arcomat.analysis.smt;

import arcomat.analysis.reachability.Logic.Answer;

import de.uni_freiburg.informatik.ultimate.logic.ApplicationTerm;
import de.uni_freiburg.informatik.ultimate.logic.ConstantTerm;
import de.uni_freiburg.informatik.ultimate.logic.Logics;
import de.uni_freiburg.informatik.ultimate.logic.Rational;
import de.uni_freiburg.informatik.ultimate.logic.SMTLIBException;
import de.uni_freiburg.informatik.ultimate.logic.Script;
import de.uni_freiburg.informatik.ultimate.logic.Script.LBool;
import de.uni_freiburg.informatik.ultimate.logic.Sort;
import de.uni_freiburg.informatik.ultimate.logic.Term;
import de.uni_freiburg.informatik.ultimate.logic.Util;
import de.uni_freiburg.informatik.ultimate.smtinterpol.DefaultLogger;
import de.uni_freiburg.informatik.ultimate.smtinterpol.LogProxy;
import de.uni_freiburg.informatik.ultimate.smtinterpol.smtlib2.SMTInterpol;

import java.math.BigInteger;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BooleanSupplier;

/** Linear integer arithmetic with Booleans: terms, assertions, and whether they can be true. */
final class Solver {
    /** How often the solver may ask, for one answer, whether to go on. */
    private static final int PATIENCE = 500;

    private final Script script;
    private final Map<String, Term> constants = new HashMap<>();
    private int asked;
    private boolean answering;

    /**
     * @param stop asked now and then; an answer is unknown once it is true
     */
    Solver(BooleanSupplier stop) {
        DefaultLogger quiet = new DefaultLogger();
        quiet.setLoglevel(LogProxy.LOGLEVEL_OFF);
        script = new SMTInterpol(quiet, () -> isToStop(stop));
        script.setOption(":produce-models", true);
        script.setLogic(Logics.QF_LIA);
    }

    /** An unknown number, known by its name. */
    Term integer(String name) {
        return constant(name, "Int");
    }

    /** An unknown truth value, known by its name. */
    Term truth(String name) {
        return constant(name, "Bool");
    }

    private Term constant(String name, String sort) {
        return constants.computeIfAbsent(
                name,
                each -> {
                    script.declareFun(each, new Sort[0], script.sort(sort));
                    return script.term(each);
                });
    }

    Term number(long value) {
        return number(BigInteger.valueOf(value));
    }

    Term number(BigInteger value) {
        Term positive = script.numeral(value.abs());
        return value.signum() < 0 ? script.term("-", positive) : positive;
    }

    Term of(boolean value) {
        return script.term(value ? "true" : "false");
    }

    Term and(List<Term> all) {
        return Util.and(script, all.toArray(new Term[0]));
    }

    Term and(Term... all) {
        return Util.and(script, all);
    }

    Term or(List<Term> all) {
        return Util.or(script, all.toArray(new Term[0]));
    }

    Term or(Term... all) {
        return Util.or(script, all);
    }

    Term not(Term term) {
        return Util.not(script, term);
    }

    Term choose(Term condition, Term then, Term otherwise) {
        return Util.ite(script, condition, then, otherwise);
    }

    Term equal(Term one, Term two) {
        return script.term("=", one, two);
    }

    /** Any other function of SMT-LIB's theory of integers. */
    Term apply(String function, Term... arguments) {
        return script.term(function, arguments);
    }

    /** Whether a number lies between two others, both included. */
    Term between(long low, Term number, long high) {
        return between(BigInteger.valueOf(low), number, BigInteger.valueOf(high));
    }

    Term between(BigInteger low, Term number, BigInteger high) {
        return and(apply("<=", number(low), number), apply("<=", number, number(high)));
    }

    /** From now on it is true. */
    void claim(Term term) {
        script.assertTerm(term);
    }

    /**
     * Whether all can be true if some terms are; these are forgotten again.
     *
     * @param ifYes may look at the example
     */
    Answer assuming(List<Term> terms, Runnable ifYes) {
        script.push(1);
        try {
            terms.forEach(script::assertTerm);
            Answer answer = answer();
            if (answer == Answer.YES) {
                ifYes.run();
            }
            return answer;
        } finally {
            script.pop(1);
        }
    }

    /** Only while it looks for an answer: what is claimed has to arrive. */
    private boolean isToStop(BooleanSupplier stop) {
        return answering && (++asked > PATIENCE || stop.getAsBoolean());
    }

    private Answer answer() {
        asked = 0;
        answering = true;
        try {
            LBool answer = script.checkSat();
            return answer == LBool.SAT
                    ? Answer.YES
                    : answer == LBool.UNSAT ? Answer.NO : Answer.UNKNOWN;
        } catch (SMTLIBException | UnsupportedOperationException notDecidable) {
            return Answer.UNKNOWN;
        } finally {
            answering = false;
        }
    }

    /** After the answer yes: an example's value of a truth value. */
    boolean truthOf(Term term) {
        return value(term).toString().equals("true");
    }

    /** After the answer yes: an example's value of a number. */
    BigInteger numberOf(Term term) {
        return number(value(term));
    }

    private Term value(Term term) {
        return Objects.requireNonNull(script.getValue(new Term[] {term}).get(term));
    }

    private static BigInteger number(Term value) {
        if (value instanceof ApplicationTerm negated) {
            return number(negated.getParameters()[0]).negate();
        }
        Object number = ((ConstantTerm) value).getValue();
        return number instanceof Rational rational ? rational.numerator() : (BigInteger) number;
    }
}
