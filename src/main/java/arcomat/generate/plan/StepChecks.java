package arcomat.generate.plan;

import arcomat.generate.text.RuntimeChecks;
import arcomat.model.Expression;
import arcomat.semantics.statement.Step;

import java.util.List;

/** Tells whether steps may go wrong, so that generated code has to look out for it. */
final class StepChecks implements Step.Cases<Boolean> {
    private StepChecks() {}

    static boolean areNeeded(List<Step> steps) {
        StepChecks checks = new StepChecks();
        return steps.stream().anyMatch(each -> each.match(checks));
    }

    private static boolean divides(Expression value) {
        return RuntimeChecks.dividesAnywhere(value);
    }

    @Override
    public Boolean declare(Step.Declare declare) {
        return divides(declare.value());
    }

    @Override
    public Boolean set(Step.Set set) {
        return divides(set.value());
    }

    @Override
    public Boolean keep(Step.Keep keep) {
        return RuntimeChecks.ANYWHERE.areNeeded(keep.value(), keep.wanted());
    }

    @Override
    public Boolean emit(Step.Emit emit) {
        return emit.emission().values().stream()
                .anyMatch(value -> RuntimeChecks.ANYWHERE.areNeeded(value, emit.port().type()));
    }

    @Override
    public Boolean choose(Step.Choose choose) {
        return divides(choose.condition())
                || areNeeded(choose.then())
                || areNeeded(choose.otherwise());
    }

    @Override
    public Boolean need(Step.Need need) {
        return divides(need.condition());
    }

    @Override
    public Boolean count(Step.Count count) {
        return false;
    }
}
