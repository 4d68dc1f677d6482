package arcomat.analysis.mona;

import arcomat.analysis.mona.Bits.Condition;
import arcomat.analysis.mona.Formula.MachineText;
import arcomat.analysis.mona.Formula.TrackText;

import java.util.ArrayList;
import java.util.List;

/** Says with bits at positions what the ports and the machines of a question do. */
final class FormulaWriter {
    private final Question question;

    FormulaWriter(Question question) {
        this.question = question;
    }

    Formula formula() {
        List<TrackText> tracks = new ArrayList<>();
        List<Condition> valid = new ArrayList<>();
        for (Track track : question.tracks()) {
            tracks.add(new TrackText(track.legend(), track.bits().names()));
            valid.addAll(track.bits().isAtMost(track.messages().size(), MachineWriter.NOW));
            if (track.total()) {
                valid.add(Condition.not(track.bits().is(0, MachineWriter.NOW)));
            }
        }
        return new Formula(
                question.leftTitle(),
                question.rightTitle(),
                tracks,
                valid,
                question.fails(),
                left(),
                rights());
    }

    /** A counterexample shows its states; so they are not hidden. */
    private MachineText left() {
        return new MachineWriter(question, question.left(), "left", false)
                .machine(question.leftTitle());
    }

    private List<MachineText> rights() {
        List<MachineText> rights = new ArrayList<>();
        for (int i = 0; i < question.rights().size(); i++) {
            String name = question.rights().size() == 1 ? "right" : "right" + (i + 1);
            rights.add(
                    new MachineWriter(question, question.rights().get(i), name, true)
                            .machine(question.rightTitles().get(i)));
        }
        return rights;
    }
}
