package arcomat.generate.view;

import java.util.List;

/**
 * States whose transitions share a method.
 *
 * @param number position among the sections; section k has the states from k * size on
 * @param draws whether a transition may have to be drawn
 */
public record SectionView(String method, int number, boolean draws, List<StateView> states) {}
