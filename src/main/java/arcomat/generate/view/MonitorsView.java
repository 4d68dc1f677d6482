package arcomat.generate.view;

import arcomat.generate.view.HeadView.AssignmentView;

import java.util.List;

/**
 * A class that watches the ports of a component for several requirements.
 *
 * @param title the component
 * @param events whether it watches events, not slices
 */
public record MonitorsView(
        HeadView head, String title, List<WatcherView> watchers, boolean events) {

    /**
     * The monitor of one requirement.
     *
     * @param name of the field
     * @param type its class
     * @param comment what the requirement is and where it is written
     * @param copies the messages on the ports
     */
    public record WatcherView(
            String name, String type, String comment, List<AssignmentView> copies) {}
}
