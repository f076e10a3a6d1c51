"""Where the statements come from, and how each source is known here."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Source:
    """A publication or a code.

    Parameters
    ----------
    name : str
        Short name, as statements use it.
    citation : str
    read : str
        What of it was read.
    """

    name: str
    citation: str
    read: str


CERDA_2003 = Source(
    "Cerda and Mahadevan 2003",
    "E. Cerda, L. Mahadevan, Geometry and physics of wrinkling, Phys. Rev. Lett. 90, 074302 (2003)",
    "the formulas, as Panaitescu et al. 2019 state them",
)
CERDA_2002 = Source(
    "Cerda et al. 2002",
    "E. Cerda, K. Ravi-Chandar, L. Mahadevan, Wrinkling of an elastic sheet under tension, Nature "
    "419, 579 (2002)",
    "the abstract; numbers from memory",
)
FRIEDL_2000 = Source(
    "Friedl et al. 2000",
    "N. Friedl, F. G. Rammerstorfer, F. D. Fischer, Buckling of stretched strips, Comput. Struct. "
    "(2000)",
    "nothing",
)
NAYYAR_2011 = Source(
    "Nayyar et al. 2011",
    "V. Nayyar, K. Ravi-Chandar, R. Huang, Stretch-induced stress patterns and wrinkles in "
    "hyperelastic thin sheets, Int. J. Solids Struct. 48, 3471 (2011)",
    "the abstract",
)
NAYYAR_2014 = Source(
    "Nayyar et al. 2014",
    "V. Nayyar, K. Ravi-Chandar, R. Huang, Stretch-induced wrinkling of polyethylene thin sheets: "
    "Experiments and modeling, Int. J. Solids Struct. 51, 1847 (2014)",
    "the abstract",
)
PUNTEL_2011 = Source(
    "Puntel et al. 2011",
    "E. Puntel, L. Deseri, E. Fried, Wrinkling of a stretched thin sheet, J. Elast. 105, 137 "
    "(2011)",
    "the abstract",
)
HEALEY_2013 = Source(
    "Healey et al. 2013",
    "T. J. Healey, Q. Li, R. Cheng, Wrinkling behavior of highly stretched rectangular elastic "
    "films via parametric global bifurcation, J. Nonlinear Sci. 23, 777 (2013)",
    "as the abstract of Sipos and Fehér 2016 quotes it; the rest from memory",
)
LI_2016 = Source(
    "Li and Healey 2016",
    "Q. Li, T. J. Healey, Stability boundaries for wrinkling in highly stretched elastic sheets, "
    "J. Mech. Phys. Solids 97 (2016)",
    "as Panaitescu et al. 2019 quote it; the rest from memory",
)
SIPOS_2016 = Source(
    "Sipos and Fehér 2016",
    "A. A. Sipos, E. Fehér, Disappearance of stretch-induced wrinkles of thin sheets: A study of "
    "orthotropic films, Int. J. Solids Struct. 97-98, 275 (2016), arXiv:1602.08607",
    "the abstract",
)
SILVESTRE_2016 = Source(
    "Silvestre 2016",
    "N. Silvestre, Wrinkling of stretched thin sheets: Is restrained Poisson's effect the sole "
    "cause? (2016)",
    "the abstract",
)
FU_2019 = Source(
    "Fu et al. 2019",
    "C. Fu, T. Wang, F. Xu, Y. Huo, M. Potier-Ferry, A modeling and resolution framework for "
    "wrinkling in hyperelastic sheets at finite membrane strain, J. Mech. Phys. Solids 124, 446 "
    "(2019)",
    "the abstract; its number as Panaitescu et al. 2019 quote it",
)
PANAITESCU_2019 = Source(
    "Panaitescu et al. 2019",
    "A. Panaitescu, M. Xin, B. Davidovitch, J. Chopin, A. Kudrolli, Birth and decay of tensional "
    "wrinkles in hyperelastic sheets, Phys. Rev. E 100, 053003 (2019)",
    "the whole paper",
)
MARTINS_2020 = Source(
    "Martins et al. 2020",
    "A. D. Martins, N. Silvestre, R. Bebiano, A new modal theory for wrinkling analysis of "
    "stretched membranes, Int. J. Mech. Sci. 175, 105519 (2020)",
    "the highlights",
)
WANG_2022 = Source(
    "Wang et al. 2022",
    "T. Wang, Y. Yang, F. Xu, Mechanics of tension-induced film wrinkling and restabilization: a "
    "review, Proc. R. Soc. A (2022)",
    "the abstract",
)
GISMO = Source(
    "G+Smo",
    "github.com/gismo/gsStructuralAnalysis: benchmarks/benchmark_Wrinkling.cpp and "
    "filedata/deformations/wrinklingPanaitescu_quarter.xml; Fig. 12 of H. M. Verhelst et al., "
    "Comput. Aided Des. 139, 103075 (2021)",
    "code and data; the figure not",
)
COMSOL = Source(
    "COMSOL",
    "Application Library of COMSOL Multiphysics, sheet_uniaxial_stretching, doc.comsol.com",
    "the page of its set-up",
)
WRINKLE_ABAQUS = Source(
    "wrinkle_abaqus",
    "github.com/Groot2theMoon/wrinkle_abaqus: run4.m and ground_truth_comsol_07070125.csv (2025)",
    "code and data",
)
