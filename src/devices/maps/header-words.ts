import type { Meaning } from './meaning.ts';
import { plainHeader } from './plain-header.ts';

/**
 * What columns are called, in English, German, French, Spanish, Italian, Dutch, Polish and Chinese. A phrase may stand for several
 * meanings: the cells decide. Compounds of German and Dutch are found by their end.
 */
const WORDS: Readonly<Partial<Record<Meaning, string>>> = {
  name: `name|register name|parameter name|point name|signal name|tag name|variable name|data name|object name|parameter|variable|signal|point|label|
    title|item|data item|data point|datapoint|quantity name|measurement|register|function|element|content|contents|meaning|register description|caption|text|
    bezeichnung|benennung|parametername|variablenname|signalname|titel|messwert|groesse|inhalt|bedeutung|datenpunkt|registername|
    nom|designation|libelle|intitule|nom du registre|variable|mesure|grandeur|nombre|nombre del registro|nombre de variable|denominacion|senal|
    nome|denominazione|grandezza|nome registro|segnale|naam|omschrijving|benaming|grootheid|
    nazwa|nazwa rejestru|nazwa zmiennej|nazwa parametru|zmienna|名称|名字|寄存器名称|参数名称|参数|变量|变量名|数据名称|数据项|信号名称|点名|内容|含义|
    info data object|unique friendly name|point|attribute|path`,
  'other-name':
    'other name|name for id|english name|german name|sensor|entity|alias|short name|abbreviation|kurzname|kuerzel|sigle|unique id|unique_id|key',
  group: `group|section|category|block|subsystem|service|module|area name|folder|gruppe|bereich|kategorie|abschnitt|baugruppe|groupe|categorie|
    grupo|categoria|seccion|gruppo|sezione|groep|rubriek|grupa|kategoria|sekcja|组|分组|类别|分类|模块`,
  description: `description|desc|comment|comments|remark|remarks|note|notes|detail|details|explanation|definition|definitions|info|information|help|
    long description|register description|function|meaning|beschreibung|bemerkung|bemerkungen|kommentar|anmerkung|hinweis|erklaerung|erlaeuterung|funktion|description|
    remarque|remarques|commentaire|commentaires|descriptif|descripcion|comentario|comentarios|observaciones|nota|notas|descrizione|commento|commenti|note|
    beschrijving|opmerking|opmerkingen|omschrijving|toelichting|opis|uwagi|komentarz|描述|说明|备注|注释|解释|注`,
  address: `address|coil|coils|coil address|discrete input|discrete inputs|input register|input registers|holding register|holding registers|from|von|start|desde|addr|adr|register address|modbus address|start address|starting address|protocol address|pdu address|wire address|data address|reg address|
    reg addr|register addr|address dec|address hex|addr dec|addr hex|dec|hex|decimal|hexadecimal|dec address|hex address|offset|register offset|address offset|modbus register address|start register|
    first register|register|registers|reg|modbus|modbus register|parameter|index|holding register address|input register address|base address|relative address|position|point address|
    adresse|registeradresse|modbusadresse|startadresse|modbus adresse|register adresse|adr|anfangsadresse|parameteradresse|
    adresse modbus|adresse registre|adresse de registre|adresse du registre|adresse de depart|registre|direccion|direccion modbus|direccion del registro|
    direccion de registro|registro|dir|indirizzo|indirizzo modbus|indirizzo registro|indirizzo del registro|adres|registeradres|modbusadres|startadres|
    adres rejestru|adres modbus|rejestr|地址|寄存器地址|起始地址|通讯地址|modbus地址|寄存器|偏移地址|首地址|十进制地址|十六进制地址|内存地址`,
  number: `number|register number|modbus number|reg no|register no|register nr|reg nr|register num|reg num|modbus no|modbus register number|plc address|modicon address|modicon|jbus|
    register|reg|registernummer|register nummer|modbus register|modbus reference|reference|entity number|numero de registre|numero registre|n registre|numero de registro|numero registro|
    n registro|registernummer|numer rejestru|nr rejestru|寄存器编号|寄存器号|plc地址|modbus point`,
  end: `end|end address|addr end|address end|last|last address|last register|stop address|to|end register|endadresse|bis|letzte adresse|adresse fin|adresse de fin|direccion final|
    ende|fin|fine|final|eind|koniec|indirizzo finale|eindadres|adres koncowy|结束地址|终止地址`,
  type: `type|data type|datatype|dtype|format|data format|value type|register format|variable type|var type|size of variable|register type|register datatype|encoding|representation|data|number format|modbus type|
    modbus data type|value format|data type and length|length|size|datentyp|typ|datenformat|variablentyp|zahlenformat|darstellung|werttyp|type de donnees|type donnee|type de donnee|format de donnees|
    tipo de dato|tipo de datos|tipo|formato|tipo dato|tipo di dato|tipo dati|formato dati|gegevenstype|typ danych|format danych|typ|数据类型|类型|数据格式|格式`,
  table: `table|register type|area|memory area|object type|registertype|data area|modbus table|modbus type|type|register kind|register area|space|reg type|data model|entity type|object|storage|kind|class|
    tabelle|registertyp|register typ|registerart|speicherbereich|art|typ|datenbereich|type de registre|zone|zone memoire|tipo de registro|tipo registro|area de memoria|tipo di registro|tipo|
    registertype|soort|typ rejestru|obszar|rodzaj|寄存器类型|数据区|区域|类型|input type|read type`,
  function: `function|function code|fc|fct|func|func code|fn|modbus function|function codes|code|read function|read function code|fcode|f code|read fc|modbus fc|supported function codes|command|
    funktionscode|funktion|fkt|fktcode|lesefunktion|code fonction|fonction|code de fonction|codigo de funcion|codigo funcion|funcion|codice funzione|funzione|functiecode|functie|
    kod funkcji|funkcja|功能码|功能|功能代码`,
  access: `access|read|readable|lesen|lecture|lectura|lettura|lezen|odczyt|读|r w|rw|read write|ro rw|access right|access rights|access type|access mode|permission|permissions|mode|type|r w type|attribute|attributes|property|properties|direction|attr|
    writable|readwrite|register access|client access|zugriff|zugriffsart|zugriffsrecht|lesen schreiben|l s|schreiben|acces|droits|lecture ecriture|l e|acceso|lectura escritura|permiso|
    accesso|lettura scrittura|toegang|lezen schrijven|dostep|odczyt zapis|读写|访问|权限|读写属性|读写权限|读 写|属性`,
  order: `order|byte order|word order|endian|endianness|endianess|byteorder|wordorder|register order|swap|data order|byte word order|bytereihenfolge|wortreihenfolge|reihenfolge|
    ordre|ordre des octets|ordre des mots|orden|orden de bytes|orden de palabras|ordine|ordine byte|ordine dei byte|volgorde|bytevolgorde|woordvolgorde|kolejnosc|kolejnosc bajtow|字节序|字序|字节顺序|字节次序`,
  words: `words|word|number of contiguous registers|number of contiguous sma modbus registers|of registers|of words|n registros|n registri|wortanzahl|寄存器数|字长|register count|registers|quantity|count|length|len|size|number of registers|no of registers|nb registers|num registers|register length|register size|data length|reg count|regs|word count|
    no of words|nb words|quantity of registers|number of words|count of registers|registry count|size words|length words|wordcount|qty|reg len|register quantity|amount|points|
    anzahl|anzahl register|registeranzahl|laenge|groesse|worte|woerter|anzahl worte|registerlaenge|nombre de registres|nb de registres|nombre de mots|nb mots|longueur|taille|mots|
    cantidad|cantidad de registros|numero de registros|longitud|tamano|palabras|numero di registri|numero registri|quantita|lunghezza|dimensione|parole|
    aantal|aantal registers|lengte|woorden|grootte|ilosc|liczba rejestrow|ilosc rejestrow|dlugosc|rozmiar|liczba slow|数量|寄存器数量|寄存器个数|长度|字数|个数|数据长度`,
  bytes:
    'bytes|length byte|laenge byte|laenge bytes|size byte|longueur octets|lunghezza byte|byte count|no of bytes|number of bytes|length bytes|size bytes|byte length|anzahl bytes|octets|nombre d octets|bajty|字节数|字节',
  'bit-size': 'bits|bit size|size bits|length bits|width|bit width|no of bits|number of bits|bitbreite|bit length|位数',
  count: 'count|repeat|array size|elements|number of values|array',
  factor: `factor|formula|calculation|formel|formule|公式|mul|scaler|conv|scale|scaling|scale factor|scalefactor|multiplier|multiplicator|resolution|accuracy|coefficient|coef|coeff|slope|gradient|lsb|conversion|conversion factor|scaling factor|unit factor|precision|
    step|ratio|magnification|multiply|mult|increment|weight|scl|faktor|skalierung|skalierungsfaktor|multiplikator|aufloesung|schrittweite|umrechnung|umrechnungsfaktor|
    facteur|echelle|facteur d echelle|multiplicateur|coefficient|factor de escala|escala|multiplicador|resolucion|coeficiente|fattore|fattore di scala|scala|moltiplicatore|risoluzione|coefficiente|
    schaal|schaalfactor|vermenigvuldiger|resolutie|vermenigvuldigingsfactor|wspolczynnik|mnoznik|skala|skalowanie|rozdzielczosc|比例|系数|倍率|比例因子|分辨率|精度|倍数|缩放|比例系数|换算系数`,
  divisor: `divisor|divider|division|division factor|divide by|divide|gain|div|scale divisor|raw per unit|teiler|divisor|diviseur|division par|dividir por|divisore|guadagno|deler|dzielnik|增益|除数`,
  exponent:
    'exponent|power|power of ten|scale exponent|exp|scale factor|sf|scale|exposant|exponente|esponente|wykladnik|指数|zehnerpotenz|scaling',
  'scale-register':
    'scale factor register|scale register|scale factor|sf|sf register|scaling register|scale factor point',
  offset: `offset|offset value|additive constant|constant|add|bias|addend|zero offset|value offset|intercept|raw offset|versatz|offsetwert|nullpunkt|decalage|desplazamiento|scostamento|verschuiving|przesuniecie|偏移|偏移量`,
  decimals: `precision|precision digits|precisione|precisie|genauigkeit|精度|decimals|decimal places|decimal|digits|decimal digits|decimal point|number of decimals|dec places|nachkommastellen|dezimalstellen|kommastellen|decimales|nombre de decimales|decimali|cifre decimali|
    decimalen|aantal decimalen|miejsca dziesietne|小数位|小数位数|小数点`,
  unit: `unit|units|unit of measurement|unit of measure|measure|engineering unit|engineering units|eu|uom|physical unit|unit of measurement|units of measure|dimension|unite|unites|einheit|einheiten|masseinheit|
    unidad|unidades|unita|unita di misura|udm|um|eenheid|eenheden|jednostka|jednostki|jedn|jm|j m|einh|eenh|dim|ud|uds|u m|单位`,
  names: `names|values|false|true|off|on|enum|enumeration|enumerations|enums|options|states|value description|bits|bit description|bit names|value list|allowed values|possible values|states list|status|mapping|map|bitmask|lookup|
    range|value range|state|coding|value meaning|value|description of values|flags|werte|werteliste|zustaende|auswahl|auspraegung|bitbelegung|wertebereich|aufzaehlung|bedeutung der werte|valeurs|etats|enumeration|liste de valeurs|
    valores|estados|opciones|valori|stati|opzioni|waarden|toestanden|opties|wartosci|stany|opcje|枚举|取值|状态|状态说明|数值说明|值说明|数据定义|定义`,
  range: `range|value range|values|limits|valid range|allowed range|data range|min max|min max value|setting range|allowed values|bereich|wertebereich|einstellbereich|grenzen|plage|plage de valeurs|limites|
    rango|intervalo|rango de valores|limites|intervallo|campo|campo valori|bereik|waardebereik|zakres|zakres wartosci|范围|取值范围|数据范围|设定范围`,
  minimum:
    'min|minimum|min value|minimum value|lower limit|low limit|least|minimalwert|mindestwert|untergrenze|valeur minimale|valeur min|minimo|valor minimo|valore minimo|minimale waarde|wartosc minimalna|最小值|最小|下限',
  maximum:
    'max|maximum|max value|maximum value|upper limit|high limit|most|maximalwert|hoechstwert|obergrenze|valeur maximale|valeur max|maximo|valor maximo|massimo|valore massimo|maximale waarde|wartosc maksymalna|wartosc maks|最大值|最大|上限',
  bit: 'bit|start bit nr|start bit|bitno|bit pos|bit no|bit number|bit position|bit index|bit nr|bitnummer|bits|numero de bit|bit offset|numer bitu|位|位号|比特',
  mask: 'mask|bit mask|bitmask|bitmaske|maske|masque|mascara|maschera|masker|maska|掩码',
  'not-implemented':
    'not implemented|not implemented value|invalid value|invalid|nan value|nan|no value|not available|na value|无效值',
  model: `model|models|variant|variants|device|devices|controller|product|supported by|applies to|available on|modell|modelle|geraet|geraete|variante|typen|modele|appareil|modelo|equipo|modello|dispositivo|model|urzadzenie|型号|机型|适用机型`,
  index:
    'index|no|nr|num|item no|row|line|seq|sequence|serial no|serial number|lfd nr|lfd|pos|position|n|numero|lp|l p|序号|编号|item|#',
  other: `default|default value|factory default|factory setting|initial value|init|start value|example|icon|device class|state class|poll|scan interval|interval|priority|version|since|firmware|default val|
    update interval|read schedule|readschedule|schedule|usertype|user type|class|standardwert|werkseinstellung|vorgabe|grundeinstellung|valeur par defaut|defaut|valor por defecto|predeterminado|valore predefinito|standaardwaarde|wartosc domyslna|domyslna|默认值|
    缺省值|出厂值|版本|category id|mandatory|static|unit id|slave|slave id|device address|station|device id|visible|enabled|cyclic write|default value`,
};

/** The meanings that a phrase may have, the likeliest ones first. */
const BY_PHRASE: ReadonlyMap<string, readonly Meaning[]> = (() => {
  const found = new Map<string, Meaning[]>();
  for (const [meaning, text] of Object.entries(WORDS) as [Meaning, string][])
    for (const phrase of text.split('|').map(plainHeader)) {
      const before = found.get(phrase);
      if (before === undefined) found.set(phrase, [meaning]);
      else if (!before.includes(meaning)) before.push(meaning);
    }
  return found;
})();

/** Endings of compounds: `Registeradresse`, `Skalierungsfaktor`. */
const ENDINGS: readonly (readonly [string, Meaning])[] = [
  ['adresse', 'address'],
  ['adres', 'address'],
  ['faktor', 'factor'],
  ['factor', 'factor'],
  ['einheit', 'unit'],
  ['eenheid', 'unit'],
  ['datentyp', 'type'],
  ['bezeichnung', 'name'],
  ['beschreibung', 'description'],
  ['nummer', 'number'],
  ['bereich', 'range'],
];
const LONGEST = 5;
/** Words that mean something only where nothing else stands beside them. */
const ALONE: ReadonlySet<string> = new Set(
  'start from von to bis desde index position pos no nr n code data step add map mode l s o e key text item class point points reg on is in value values bit bits function meaning content contents parameter length size range'.split(
    ' ',
  ),
);

/** Words that say what a header is about if they are its last one. */
const LAST: ReadonlySet<string> = new Set(
  'name description address type unit factor access datatype bezeichnung beschreibung'.split(' '),
);

/** How surely a header names a meaning. */
export interface HeaderMatch {
  readonly meaning: Meaning;
  /** 3 the whole header, 2 the words outside its brackets, 1 a part of it; less by a little for each meaning that is likelier. */
  readonly strength: number;
}

/** What a header may say, the surest first. Empty for a header that says nothing known. */
export function headerMatches(header: string): readonly HeaderMatch[] {
  const found = new Map<Meaning, number>();
  const add = (phrase: string, strength: number) => {
    BY_PHRASE.get(phrase)?.forEach((meaning, place) => {
      const sure = strength - place * 0.1;
      if ((found.get(meaning) ?? 0) < sure) found.set(meaning, sure);
    });
  };
  const whole = plainHeader(header);
  add(whole, 3);
  add(plainHeader(header.replace(/[([{（【][^)\]}）】]*[)\]}）】]?/g, ' ')), 2.9);
  add(plainHeader(header.split(/[.\n]/).at(-1) ?? ''), 2.5);
  const words = whole.split(' ');
  for (let from = 0; from < words.length; from++)
    for (let length = Math.min(LONGEST, words.length - from); length > 0; length--)
      if (length > 1 || !ALONE.has(words[from] ?? ''))
        add(words.slice(from, from + length).join(' '), 1 + (0.9 * length) / words.length);
  // `Documented name`, `Signal description`: the last word says what it is.
  if (words.length > 1 && LAST.has(words.at(-1) ?? '')) add(words.at(-1) ?? '', 2.2);
  for (const [ending, meaning] of ENDINGS) if (found.size === 0 && whole.endsWith(ending)) found.set(meaning, 1.5);
  if (/[\u4e00-\u9fff]/.test(whole))
    for (const [phrase] of BY_PHRASE)
      if (/[\u4e00-\u9fff]/.test(phrase) && whole.includes(phrase))
        add(phrase, 1 + (0.9 * phrase.length) / whole.length);
  return Array.from(found, ([meaning, strength]) => ({ meaning, strength })).sort((a, b) => b.strength - a.strength);
}
