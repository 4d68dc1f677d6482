package arcomat.report.page;

import java.util.List;

/**
 * A run with what there is to say about it.
 *
 * @param headline what came of it, in a sentence; empty where the page's headline says it
 * @param drawings pictures that follow the run
 */
public record Story(
        String title,
        Tone tone,
        String headline,
        List<Remark> remarks,
        Timeline timeline,
        List<Drawing> drawings) {
    public Story {
        remarks = List.copyOf(remarks);
        drawings = List.copyOf(drawings);
    }
}
