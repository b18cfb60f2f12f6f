"""What laboratories write beside the numbers, in five languages.

Units are in round brackets here; table.py writes them in other ways too. RARE words are understood by people and need
not be by programs.
"""

LANGUAGES = ("en", "de", "fr", "es", "it")
SERIES_OF = {"en": ("ASTM", "ASTM", "BS", "EN"), "de": ("ISO", "EN"), "fr": ("AFNOR",), "es": ("UNE", "AFNOR"),
             "it": ("CNR", "EN")}

SIZE = {
    "en": ("Sieve size", "Sieve opening", "Sieve aperture", "Sieve aperture size", "Opening", "Aperture", "Aperture size",
           "Grain size", "Particle size", "Test sieve", "BS test sieve", "Sieve", "Size", "Diameter", "Mesh size",
           "Particle diameter", "Test sieve size", "Sieve opening size"),
    "de": ("Siebweite", "Maschenweite", "Siebgröße", "Sieböffnung", "Öffnungsweite", "Lochweite", "Korngröße",
           "Korndurchmesser", "Korndurchmesser d", "Sieb", "Prüfsieb"),
    "fr": ("Ouverture", "Ouverture des mailles", "Ouverture du tamis", "Tamis", "Maille", "Diamètre"),
    "es": ("Abertura", "Tamiz", "Abertura del tamiz", "Abertura de malla", "Diámetro"),
    "it": ("Apertura", "Setaccio", "Apertura setaccio", "Apertura delle maglie", "Diametro", "Crivello"),
}
SIZE_RARE = {
    "en": ("Sieve diameter", "Nominal aperture", "Sieve mesh", "D"),
    "de": ("Nennweite", "Kornklasse bis", "d"),
    "fr": ("Diamètre des tamis", "Dimension des mailles", "Module"),
    "es": ("Luz de malla", "Tamaño de tamiz", "Tamices"),
    "it": ("Diametro setaccio", "Luce netta", "Vaglio"),
}
NAMED_SIEVE = ("Sieve", "Sieve No.", "Sieve no", "US sieve", "U.S. Standard Sieve", "Sieve designation", "Sieve number",
               "Sieve name", "US Sieve No.")

# (meaning, unit) of a column.
RETAINED_MASS, RETAINED_PERCENT = ("retained", "g"), ("retained", "%")
CUMULATIVE_MASS, CUMULATIVE_PERCENT = ("cumulative", "g"), ("cumulative", "%")
PASSING_PERCENT, PASSING_MASS = ("passing", "%"), ("passing", "g")

COLUMN = {
    RETAINED_MASS: {
        "en": ("Mass retained (g)", "Weight retained (g)", "Retained mass (g)", "Wt. retained (g)", "Retained (g)",
               "Mass of soil retained (g)", "Individual mass retained (g)", "Mass of material retained (g)", "Ri (g)",
               "Mass retained on sieve (g)", "Mass of material retained Ri (g)", "Weight (g)", "Mass (g)"),
        "de": ("Rückstand (g)", "Siebrückstand (g)", "Rückstand Masse (g)", "Einzelrückstand (g)", "Masse (g)",
               "Masse Rückstand (g)"),
        "fr": ("Refus partiel (g)", "Refus partiels (g)", "Masse retenue (g)"),
        "es": ("Masa retenida (g)", "Peso retenido (g)", "Retenido parcial (g)"),
        "it": ("Massa trattenuta (g)", "Peso trattenuto (g)", "Trattenuto parziale (g)"),
    },
    RETAINED_PERCENT: {
        "en": ("% retained", "Percent retained", "Retained (%)", "Percentage retained", "Individual % retained",
               "Mass retained (%)"),
        "de": ("Rückstand (%)", "Rückstand (M.-%)", "Siebrückstand (Gew.-%)", "Einzelrückstand (%)"),
        "fr": ("Refus partiel (%)", "% refus partiels", "Refus partiels (%)"),
        "es": ("% retenido parcial", "Retenido parcial (%)"),
        "it": ("Trattenuto parziale (%)", "% trattenuto parziale"),
    },
    CUMULATIVE_MASS: {
        "en": ("Cumulative mass retained (g)", "Cum. mass retained (g)", "Cumulative weight retained (g)",
               "Cumulative retained (g)"),
        "de": ("Summe Rückstand (g)", "Rückstand kumuliert (g)", "Rückstandssumme (g)"),
        "fr": ("Refus cumulé (g)", "Refus cumulés (g)"),
        "es": ("Retenido acumulado (g)",),
        "it": ("Trattenuto cumulato (g)", "Trattenuto cumulativo (g)"),
    },
    CUMULATIVE_PERCENT: {
        "en": ("Cumulative % retained", "Cumulative percent retained", "Cumulative retained (%)", "Cum. % retained"),
        "de": ("Summe Rückstand (%)", "Rückstand kumuliert (%)", "Rückstandssumme (M.-%)", "Summe der Rückstände (%)"),
        "fr": ("Refus cumulés (%)", "% refus cumulés", "Refus cumulé (%)"),
        "es": ("% retenido acumulado", "Retenido acumulado (%)"),
        "it": ("Trattenuto cumulato (%)", "% trattenuto cumulato"),
    },
    PASSING_PERCENT: {
        "en": ("% passing", "Percent passing", "Passing (%)", "Percentage passing", "Cumulative % passing", "% finer",
               "Percent finer", "Percent finer by mass", "% finer by weight", "Cumulative percent passing",
               "Cumulative passing (%)", "Total % passing", "Passing, %", "Cumulative % finer"),
        "de": ("Durchgang (%)", "Siebdurchgang (M.-%)", "Durchgang (M.-%)", "Durchgang kumuliert (%)",
               "Durchgangssumme (%)"),
        "fr": ("Tamisat (%)", "Tamisats cumulés (%)", "% tamisats", "Passant (%)", "% passant", "Passants cumulés (%)"),
        "es": ("% que pasa", "Pasa (%)", "% pasa", "% pasante", "Pasante acumulado (%)"),
        "it": ("Passante (%)", "% passante", "Passante cumulato (%)", "% passante cumulato"),
    },
}
COLUMN_RARE = {
    RETAINED_MASS: {
        "en": ("Soil retained (g)", "Mass of soil retained on each sieve (g)", "Mass ret. (g)", "Grams retained"),
        "de": ("Rückstand auf Sieb (g)", "Siebrückstand Masse (g)", "Auswaage (g)"),
        "fr": ("Masse des refus partiels (g)", "Poids retenu (g)"),
        "es": ("Masa retenida parcial (g)", "Retenido (g)", "Peso retenido parcial (g)"),
        "it": ("Peso trattenuto parziale (g)", "Trattenuto (g)"),
    },
    RETAINED_PERCENT: {
        "en": ("Percentage of mass retained", "% ret.", "100 Ri/M1 (%)", "Fractional %"),
        "de": ("Massenanteil (%)", "Anteil Rückstand (%)"),
        "fr": ("% refus", "Refus (%)"),
        "es": ("% retenido", "Porcentaje retenido"),
        "it": ("% trattenuto", "Trattenuto (%)"),
    },
    CUMULATIVE_MASS: {
        "en": ("Cumul. wt. retained (g)", "Sum retained (g)"),
        "de": ("Rückstand Summe (g)",),
        "fr": ("Masse des refus cumulés (g)", "Masse des refus cumulés Ri (g)"),
        "es": ("Masa retenida acumulada (g)", "Peso retenido acumulado (g)"),
        "it": ("Peso trattenuto cumulato (g)",),
    },
    CUMULATIVE_PERCENT: {
        "en": ("% cumulative retained", "Total % retained"),
        "de": ("Summe der Siebrückstände (M.-%)",),
        "fr": ("Refus cumulés en %", "Pourcentage de refus cumulés"),
        "es": ("% acumulado retenido", "Porcentaje retenido acumulado"),
        "it": ("% trattenuto progressivo", "Trattenuto progressivo (%)"),
    },
    PASSING_PERCENT: {
        "en": ("Percentage by mass passing", "Cumulative percentage passing", "P (%)", "% smaller", "Undersize (%)"),
        "de": ("Summe der Siebdurchgänge (M.-%)", "Siebdurchgang a (%)", "Massenanteil < d (%)"),
        "fr": ("Pourcentage cumulé de tamisats", "Tamisats cumulés en %", "% cumulé passant"),
        "es": ("Porcentaje que pasa", "% acumulado que pasa", "Pasa acumulado (%)"),
        "it": ("% passante totale", "Passante totale (%)"),
    },
}

# {o} is the finest opening as the sheet writes it, with its unit where {u} is.
PAN = {
    "en": ("Pan", "pan", "PAN", "In pan", "Receiver", "Material in the pan P", "Pan (P)"),
    "de": ("Schale", "Auffangschale", "Boden", "Bodenschale", "Siebboden"),
    "fr": ("Fond", "fond"),
    "es": ("Fondo", "fondo"),
    "it": ("Fondo", "fondo"),
}
PAN_OF_OPENING = ("< {o}", "<{o}", "< {o} {u}", "<{o} {u}")
PAN_OF_OPENING_EN = ("Passing {o} {u}",)
PAN_OF_NUMBER = ("Minus No. {n}", "Passing No. {n}", "Pan (< No. {n})", "Minus #{n}")
PAN_RARE = {
    "en": ("Bottom pan", "Collecting pan", "Fines", "Fines (pan)", "Base", "Pan material", "Finer"),
    "de": ("Pfanne", "Rest", "Unterkorn", "Feinanteil"),
    "fr": ("Plateau", "Fond de tamis", "Réceptacle", "Fines"),
    "es": ("Bandeja", "Cazoleta", "Ciego", "Platillo", "Finos"),
    "it": ("Vassoio", "Fondello", "Fini", "Raccoglitore"),
}
WASH = {
    "en": ("Wash loss", "Loss on wash", "Loss on washing", "Washed out", "Fines (washing)", "Loss by washing"),
    "de": ("Auswaschverlust", "Waschverlust", "Abschlämmbares"),
    "fr": ("Perte au lavage", "Fines éliminées par lavage"),
    "es": ("Pérdida por lavado", "Finos por lavado"),
    "it": ("Perdita per lavaggio", "Perdita al lavaggio"),
}
WASH_RARE = {
    "en": ("Fines removed by washing", "Washed fines", "Material finer than 75 µm by washing", "Wash water fines",
           "Decanted fines"),
    "de": ("Abschlämmverlust", "Abgeschlämmt", "Schlämmverlust", "Nass abgesiebt"),
    "fr": ("Lavage", "Éléments éliminés au lavage", "Passant au lavage"),
    "es": ("Lavado", "Pasa por lavado", "Material lavado"),
    "it": ("Lavaggio", "Fini da lavaggio", "Materiale lavato"),
}
PAN_AND_WASH = {
    "en": ("Pan + wash", "Pan + wash loss", "Pan and wash"),
    "de": ("Schale + Auswaschverlust", "Schale + Waschverlust"),
    "fr": ("Fond + lavage", "Fond + perte au lavage"),
    "es": ("Fondo + lavado",),
    "it": ("Fondo + lavaggio",),
}
TOTAL = {
    "en": ("Total", "TOTAL", "Sum", "Total mass"),
    "de": ("Summe", "Gesamt", "Gesamtmasse"),
    "fr": ("Total", "Somme"),
    "es": ("Total", "Suma"),
    "it": ("Totale", "Somma"),
}

DRY_MASS = {
    "en": ("Initial dry mass", "Dry mass before wash", "Dry mass before washing", "Total dry mass", "Total dry mass M1",
           "Dry mass of sample", "Mass of dry sample"),
    "de": ("Trockenmasse vor dem Waschen", "Einwaage", "Trockenmasse"),
    "fr": ("Masse sèche initiale", "Masse sèche totale", "Masse sèche totale M1"),
    "es": ("Masa seca inicial", "Masa seca total", "Masa seca antes del lavado"),
    "it": ("Massa secca iniziale", "Massa secca totale", "Peso secco iniziale"),
}
MASS_AFTER_WASHING = {
    "en": ("Dry mass after washing", "Dry mass after wash", "Mass after washing", "Dry mass after washing M2"),
    "de": ("Trockenmasse nach dem Waschen",),
    "fr": ("Masse sèche après lavage", "Masse sèche après lavage M2"),
    "es": ("Masa seca después del lavado",),
    "it": ("Massa secca dopo lavaggio",),
}

TITLE = {
    "en": ("Particle size distribution", "Sieve analysis", "Grain size analysis, ASTM D6913", "PSD to BS 1377-2",
           "EN 933-1, washing and sieving"),
    "de": ("Korngrößenverteilung", "Siebanalyse DIN 18123", "Bestimmung der Korngrößenverteilung, Nasssiebung"),
    "fr": ("Analyse granulométrique", "Analyse granulométrique par tamisage NF P 94-056"),
    "es": ("Análisis granulométrico por tamizado", "Granulometría UNE 103101"),
    "it": ("Analisi granulometrica", "Analisi granulometrica CNR 23"),
}
PROJECT = {"en": "Project", "de": "Projekt", "fr": "Chantier", "es": "Obra", "it": "Cantiere"}
SAMPLE_NAME = {"en": "Sample", "de": "Probe", "fr": "Échantillon", "es": "Muestra", "it": "Campione"}
DEPTH = {"en": "Depth (m)", "de": "Tiefe [m]", "fr": "Profondeur (m)", "es": "Profundidad (m)", "it": "Profondità (m)"}
DATE = {"en": "Date", "de": "Datum", "fr": "Date", "es": "Fecha", "it": "Data"}
OPERATOR = {"en": "Tested by", "de": "Bearbeiter", "fr": "Opérateur", "es": "Operador", "it": "Operatore"}
REMARK = {
    "en": ("Remarks: washed over the finest sieve", "Checked by J. Smith", "Brown silty SAND"),
    "de": ("Bemerkungen: keine", "Geprüft: M. Weiß", "Sand, schwach schluffig"),
    "fr": ("Observations : néant", "Sable limoneux brun"),
    "es": ("Observaciones: ninguna", "Arena limosa"),
    "it": ("Note: nessuna", "Sabbia limosa"),
}
