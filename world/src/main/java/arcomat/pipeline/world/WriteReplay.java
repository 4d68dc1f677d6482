package arcomat.pipeline.world;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.file.ReportPage;
import arcomat.report.world.Ghost;
import arcomat.report.world.WorldJson;
import arcomat.report.world.WorldPage;
import arcomat.simulate.run.RobotRun;
import arcomat.world.Recording;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * Writes a page that plays a run of a world again and, beside it, the recording that it plays.
 *
 * @param inside what the programs of robots did
 * @param ghost another run to be shown beside it
 * @param title of the page
 * @param folder of the page, as the user wrote it
 */
public record WriteReplay(
        Recording recording,
        List<RobotRun> inside,
        Optional<Ghost> ghost,
        String title,
        String folder)
        implements Task<String> {
    private static final String RECORDING = "recording.json";

    /**
     * A run that was recorded before.
     *
     * @param file as {@code --report} writes it, as the user named it
     * @throws WrongUse where it cannot be read, or is no recording
     */
    public static Ghost ghost(String file, Session session) throws WrongUse {
        String text = FileReader.required("recording", file, session.names()).text();
        Optional<Ghost> ghost = Ghost.read(text, file);
        if (ghost.isEmpty()) {
            throw new WrongUse(
                    "'%s' is no recording of a run; 'arcomat world --report DIR' writes one, %s",
                    file, "DIR/" + RECORDING);
        }
        return ghost.get();
    }

    /**
     * Returns the path of the page.
     *
     * @throws WrongUse where the folder is somebody else's, or cannot be written
     */
    @Override
    public String run(Session session) throws WrongUse {
        new ReportPage(folder, session.names())
                .write(WorldPage.render(recording, inside, ghost, title));
        try {
            AtomicFile.write(
                    session.names().resolve(folder).resolve(RECORDING),
                    WorldJson.render(recording));
        } catch (IOException e) {
            throw Failures.cannot("write to", folder, e);
        }
        return folder + "/" + ReportPage.NAME;
    }
}
