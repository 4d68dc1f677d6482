package arcomat.analysis.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.NaiveInclusion;
import arcomat.analysis.evolution.EditRow.Edited;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton.Completion;
import arcomat.semantics.Promise;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.lifecycle.AfterProperty;

import java.util.List;

/**
 * Which edits of an automaton keep its promises, for each completion: the table in the semantics.
 * An edited automaton of the left fails where enumeration finds a failure; instances in which the
 * edit does not show within some inputs are left aside, and counted.
 */
@Tag("slow")
class EditTableProperties {
    private static final int WANTED = 400;
    private static final int TRIES = 560;
    private static final int LENGTH = 5;

    private int kept;
    private int leftAside;

    private void holds(Edited edited) {
        kept++;
        assertThat(verdict(edited).answer()).isEqualTo(Answer.HOLDS);
        assertThat(enumerationFails(edited)).isFalse();
    }

    private void fails(Edited edited) {
        if (enumerationFails(edited)) {
            kept++;
            assertThat(verdict(edited).answer()).isEqualTo(Answer.FAILS);
        } else {
            leftAside++;
        }
    }

    private static boolean enumerationFails(Edited edited) {
        return new NaiveInclusion(left(edited), right(edited)).shortestFailure(LENGTH).isPresent();
    }

    private static Verdict verdict(Edited edited) {
        return Refinement.check(left(edited), right(edited), Budget.ofMemory());
    }

    private static Promise left(Edited edited) {
        return Promise.of(edited.after().component("Left"), List.of());
    }

    private static Promise right(Edited edited) {
        return Promise.of(edited.before().component("Right"), List.of());
    }

    @AfterProperty
    void enoughInstancesMattered() {
        System.out.printf("%d instances, %d left aside%n", kept, leftAside);
        assertThat(kept).isGreaterThanOrEqualTo(WANTED);
    }

    @Property(seed = "1", tries = TRIES)
    void dropOneOfTwoChaos(@ForAll("dropOneOfTwoChaos") Edited edited) {
        holds(edited);
    }

    @Provide("dropOneOfTwoChaos")
    Arbitrary<Edited> dropOneOfTwoChaos() {
        return EditRow.DROP_ONE_OF_TWO.with(Completion.CHAOS, false);
    }

    @Property(seed = "1", tries = TRIES)
    void dropOneOfTwoOutput(@ForAll("dropOneOfTwoOutput") Edited edited) {
        holds(edited);
    }

    @Provide("dropOneOfTwoOutput")
    Arbitrary<Edited> dropOneOfTwoOutput() {
        return EditRow.DROP_ONE_OF_TWO.with(Completion.OUTPUT, false);
    }

    @Property(seed = "1", tries = TRIES)
    void dropOneOfTwoIgnore(@ForAll("dropOneOfTwoIgnore") Edited edited) {
        holds(edited);
    }

    @Provide("dropOneOfTwoIgnore")
    Arbitrary<Edited> dropOneOfTwoIgnore() {
        return EditRow.DROP_ONE_OF_TWO.with(Completion.IGNORE, false);
    }

    @Property(seed = "1", tries = TRIES)
    void dropTheOnlyOneChaos(@ForAll("dropTheOnlyOneChaos") Edited edited) {
        fails(edited);
    }

    @Provide("dropTheOnlyOneChaos")
    Arbitrary<Edited> dropTheOnlyOneChaos() {
        return EditRow.DROP_THE_ONLY_ONE.with(Completion.CHAOS, false);
    }

    @Property(seed = "1", tries = TRIES)
    void dropTheOnlyOneOutput(@ForAll("dropTheOnlyOneOutput") Edited edited) {
        fails(edited);
    }

    @Provide("dropTheOnlyOneOutput")
    Arbitrary<Edited> dropTheOnlyOneOutput() {
        return EditRow.DROP_THE_ONLY_ONE.with(Completion.OUTPUT, false);
    }

    @Property(seed = "1", tries = TRIES)
    void dropTheOnlyOneIgnore(@ForAll("dropTheOnlyOneIgnore") Edited edited) {
        fails(edited);
    }

    @Provide("dropTheOnlyOneIgnore")
    Arbitrary<Edited> dropTheOnlyOneIgnore() {
        return EditRow.DROP_THE_ONLY_ONE.with(Completion.IGNORE, false);
    }

    @Property(seed = "1", tries = TRIES)
    void addALoopChaos(@ForAll("addALoopChaos") Edited edited) {
        holds(edited);
    }

    @Provide("addALoopChaos")
    Arbitrary<Edited> addALoopChaos() {
        return EditRow.ADD_A_LOOP.with(Completion.CHAOS, false);
    }

    @Property(seed = "1", tries = TRIES)
    void addALoopOutput(@ForAll("addALoopOutput") Edited edited) {
        holds(edited);
    }

    @Provide("addALoopOutput")
    Arbitrary<Edited> addALoopOutput() {
        return EditRow.ADD_A_LOOP.with(Completion.OUTPUT, false);
    }

    @Property(seed = "1", tries = TRIES)
    void addALoopIgnore(@ForAll("addALoopIgnore") Edited edited) {
        fails(edited);
    }

    @Provide("addALoopIgnore")
    Arbitrary<Edited> addALoopIgnore() {
        return EditRow.ADD_A_LOOP.with(Completion.IGNORE, false);
    }

    @Property(seed = "1", tries = TRIES)
    void addAChangeOfStateChaos(@ForAll("addAChangeOfStateChaos") Edited edited) {
        holds(edited);
    }

    @Provide("addAChangeOfStateChaos")
    Arbitrary<Edited> addAChangeOfStateChaos() {
        return EditRow.ADD_A_CHANGE_OF_STATE.with(Completion.CHAOS, false);
    }

    @Property(seed = "1", tries = TRIES)
    void addAChangeOfStateOutput(@ForAll("addAChangeOfStateOutput") Edited edited) {
        fails(edited);
    }

    @Provide("addAChangeOfStateOutput")
    Arbitrary<Edited> addAChangeOfStateOutput() {
        return EditRow.ADD_A_CHANGE_OF_STATE.with(Completion.OUTPUT, false);
    }

    @Property(seed = "1", tries = TRIES)
    void addAChangeOfStateIgnore(@ForAll("addAChangeOfStateIgnore") Edited edited) {
        fails(edited);
    }

    @Provide("addAChangeOfStateIgnore")
    Arbitrary<Edited> addAChangeOfStateIgnore() {
        return EditRow.ADD_A_CHANGE_OF_STATE.with(Completion.IGNORE, false);
    }

    @Property(seed = "1", tries = TRIES)
    void assignAnOmittedOutputChaos(@ForAll("assignAnOmittedOutputChaos") Edited edited) {
        fails(edited);
    }

    @Provide("assignAnOmittedOutputChaos")
    Arbitrary<Edited> assignAnOmittedOutputChaos() {
        return EditRow.ASSIGN_AN_OMITTED_OUTPUT.with(Completion.CHAOS, false);
    }

    @Property(seed = "1", tries = TRIES)
    void assignAnOmittedOutputOutput(@ForAll("assignAnOmittedOutputOutput") Edited edited) {
        fails(edited);
    }

    @Provide("assignAnOmittedOutputOutput")
    Arbitrary<Edited> assignAnOmittedOutputOutput() {
        return EditRow.ASSIGN_AN_OMITTED_OUTPUT.with(Completion.OUTPUT, false);
    }

    @Property(seed = "1", tries = TRIES)
    void assignAnOmittedOutputIgnore(@ForAll("assignAnOmittedOutputIgnore") Edited edited) {
        fails(edited);
    }

    @Provide("assignAnOmittedOutputIgnore")
    Arbitrary<Edited> assignAnOmittedOutputIgnore() {
        return EditRow.ASSIGN_AN_OMITTED_OUTPUT.with(Completion.IGNORE, false);
    }

    @Property(seed = "1", tries = TRIES)
    void assignAnOmittedFreeOutputChaos(@ForAll("assignAnOmittedFreeOutputChaos") Edited edited) {
        holds(edited);
    }

    @Provide("assignAnOmittedFreeOutputChaos")
    Arbitrary<Edited> assignAnOmittedFreeOutputChaos() {
        return EditRow.ASSIGN_AN_OMITTED_OUTPUT.with(Completion.CHAOS, true);
    }

    @Property(seed = "1", tries = TRIES)
    void assignAnOmittedFreeOutputOutput(@ForAll("assignAnOmittedFreeOutputOutput") Edited edited) {
        holds(edited);
    }

    @Provide("assignAnOmittedFreeOutputOutput")
    Arbitrary<Edited> assignAnOmittedFreeOutputOutput() {
        return EditRow.ASSIGN_AN_OMITTED_OUTPUT.with(Completion.OUTPUT, true);
    }

    @Property(seed = "1", tries = TRIES)
    void assignAnOmittedFreeOutputIgnore(@ForAll("assignAnOmittedFreeOutputIgnore") Edited edited) {
        holds(edited);
    }

    @Provide("assignAnOmittedFreeOutputIgnore")
    Arbitrary<Edited> assignAnOmittedFreeOutputIgnore() {
        return EditRow.ASSIGN_AN_OMITTED_OUTPUT.with(Completion.IGNORE, true);
    }
}
